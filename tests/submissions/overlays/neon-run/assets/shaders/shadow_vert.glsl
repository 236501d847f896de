#version 330 core

layout(location = 0) in vec3 position;

uniform mat4 model;
uniform mat4 moonMatrix;

void main() {
    gl_Position = moonMatrix * model * vec4(position, 1.0);
}
