#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 modelToView;
uniform mat4 normalToView;
uniform mat4 viewToClip;
uniform vec2 tiling;

// VS = view space
out vec3 fragmentVS;
out vec3 normalVS;
out vec2 uv;

void main() {
    vec4 vertexVS = modelToView * vec4(position, 1.0);

    fragmentVS = vertexVS.xyz;
    normalVS = mat3(normalToView) * normal;
    uv = texCoord * tiling;

    gl_Position = viewToClip * vertexVS;
}
