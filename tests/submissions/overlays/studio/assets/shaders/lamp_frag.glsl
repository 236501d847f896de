#version 330 core
flat in vec3 lampColor;
out vec4 color;

void main() {
    color = vec4(lampColor, 1.0);
}
