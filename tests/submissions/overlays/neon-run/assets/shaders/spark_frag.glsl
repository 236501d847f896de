#version 330 core

in vec4 spark;

out vec4 color;

void main() {
    float r = length(gl_PointCoord - vec2(0.5));
    color = vec4(spark.rgb, spark.a * smoothstep(0.5, 0.1, r));
}
