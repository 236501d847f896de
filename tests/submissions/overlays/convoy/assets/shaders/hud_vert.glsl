#version 330 core
layout(location = 0) in vec3 inPos;

uniform vec2 offset;
uniform vec2 size;

void main() {
    gl_Position = vec4(inPos.xy * size + offset, 0.0, 1.0);
}
