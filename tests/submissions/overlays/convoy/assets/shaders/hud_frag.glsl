#version 330 core
uniform vec3 barColor;
out vec4 fragColor;

void main() {
    fragColor = vec4(barColor, 1.0);
}
