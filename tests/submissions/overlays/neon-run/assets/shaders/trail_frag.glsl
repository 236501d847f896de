#version 330 core

in float age;

uniform vec3 trailColor;

out vec4 color;

void main() {
    color = vec4(trailColor, 0.5 * age * age);
}
