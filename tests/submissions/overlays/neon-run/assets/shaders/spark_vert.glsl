#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colorAndLife;

uniform mat4 view;
uniform mat4 projection;

out vec4 spark;

void main() {
    spark = colorAndLife;
    gl_Position = projection * view * vec4(position, 1.0);
    gl_PointSize = 60.0 / gl_Position.w;
}
