#version 330 core
//#include shading.glsl

in vec3 position;
in vec3 normal;
in vec2 uv;

out vec4 color;

void main() {
    vec3 n = normalize(gl_FrontFacing ? normal : -normal);
    color = vec4(shade(position, n, uv), 1.0);
}
