#version 330 core

// w: 0 at the old end, 1 at the motorcycle
layout(location = 0) in vec4 point;

uniform mat4 view;
uniform mat4 projection;

out float age;

void main() {
    age = point.w;
    gl_Position = projection * view * vec4(point.xyz, 1.0);
}
