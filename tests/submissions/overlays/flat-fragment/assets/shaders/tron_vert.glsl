#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

out vec2 tc;
out vec3 normalView;
out vec3 posView;

void main() {
    mat4 modelView = view * model;
    vec4 pos = modelView * vec4(position, 1.0);
    gl_Position = projection * pos;

    tc = texCoord * tcMultiplier;
    normalView = transpose(inverse(mat3(modelView))) * normal;

    posView = pos.xyz;
}
