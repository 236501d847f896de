#version 330 core

layout(location = 0) in vec3 aPos;
layout(location = 1) in vec2 aUv;
layout(location = 2) in vec3 aNormal;

uniform mat4 uModelView;
uniform mat4 uProjection;
uniform vec2 uTiling;

out vec3 vPos;
out vec3 vNormal;
out vec2 vUv;

void main() {
    vec4 viewPos = uModelView * vec4(aPos, 1.0);
    gl_Position = uProjection * viewPos;
    vPos = viewPos.xyz;
    vNormal = mat3(uModelView) * aNormal; // everything is scaled uniformly
    vUv = aUv * uTiling;
}
