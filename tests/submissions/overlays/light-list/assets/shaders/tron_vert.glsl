#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 tc;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

out vec3 fragPos;
out vec2 texCoord;
out vec3 fragNormal;

void main() {
    vec4 viewPos = view * model * vec4(position, 1.0);
    gl_Position = projection * viewPos;

    fragPos = viewPos.xyz;
    fragNormal = mat3(transpose(inverse(view * model))) * normal;
    texCoord = tc * tcMultiplier;

    // old version, moved to the fragment shader because of the loop
    // toCamera = -viewPos.xyz;
    // toLight = (view * vec4(lightPos, 1.0)).xyz - viewPos.xyz;
}
