#version 330 core

layout(location = 0) in vec2 position;

uniform vec2 ecke;
uniform vec2 groesse;

void main() {
    gl_Position = vec4(ecke + position * groesse, 0.0, 1.0);
}
