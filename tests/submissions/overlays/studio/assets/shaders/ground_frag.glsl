#version 330 core
//#include shading.glsl

in vec3 position;
in vec3 normal;
in vec2 uv;

out vec4 color;

void main() {
    color = vec4(shade(position, normalize(normal), uv), 1.0);
}
