#version 330 core

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec2 aUv;
layout(location = 2) in vec3 aNormal;

uniform mat4 modelView;
uniform mat4 normalMatrix;
uniform mat4 projection;
uniform vec2 tiles;

out vec2 uv;
out vec3 normal;
out vec3 toCamera;

void main() {
    vec4 p = modelView * vec4(aPosition, 1.0);
    uv = aUv * tiles;
    normal = mat3(normalMatrix) * aNormal;
    toCamera = -p.xyz;
    gl_Position = projection * p;
}
