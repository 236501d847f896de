#version 330 core
// The gizmos: their colour, fainter where they are behind something.

in vec3 tint;

uniform float strength;

out vec4 fragColor;

void main() {
    fragColor = vec4(tint, strength);
}
