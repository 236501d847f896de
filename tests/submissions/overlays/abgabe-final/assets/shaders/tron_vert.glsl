#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

// everything in view space
out vec3 fragPos;
out vec3 fragNormal;
out vec2 fragTc;

void main() {
    vec4 viewPos = view * model * vec4(position, 1.0);
    fragPos = viewPos.xyz;
    fragNormal = mat3(view * model) * normal; // only uniform scaling
    fragTc = texCoord * tcMultiplier;
    gl_Position = projection * viewPos;
}
