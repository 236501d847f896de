#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 colorIn;

out vec3 colorVS;

void main() {
    gl_Position = vec4(position.xy, -position.z, 1.0);
    colorVS = colorIn;
}
