#version 330 core

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec2 aTexCoord;
layout(location = 2) in vec3 aNormal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

out vec3 fragPos;
out vec3 fragNormal;
out vec2 texCoord;

void main() {
    mat4 modelView = view * model;
    // everything in view space
    fragPos = vec3(modelView * vec4(aPosition, 1.0));
    fragNormal = mat3(modelView) * aNormal;
    texCoord = aTexCoord * tcMultiplier;
    gl_Position = projection * vec4(fragPos, 1.0);
}
