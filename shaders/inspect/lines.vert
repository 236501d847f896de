#version 330 core
// The gizmos: lines in world space.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 color;

uniform mat4 toClip;  // world space -> clip space

out vec3 tint;

void main() {
    tint = color;
    gl_Position = toClip * vec4(position, 1.0);
}
