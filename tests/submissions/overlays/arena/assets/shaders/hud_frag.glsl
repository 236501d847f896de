#version 330 core

uniform vec3 farbe;
uniform float alpha;

out vec4 color;

void main() {
    color = vec4(farbe, alpha);
}
