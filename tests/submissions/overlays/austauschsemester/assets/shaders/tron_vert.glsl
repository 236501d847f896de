#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 modelView;
uniform mat4 projection;
uniform mat4 normals;
uniform vec2 repeat;

out vec3 vPos;
out vec3 vNormal;
out vec2 vTex;

void main() {
    vec4 p = modelView * vec4(position, 1.0);

    // the lights are calculated in the fragment shader, it only needs the point in view space
    vPos = p.xyz;
    vNormal = mat3(normals) * normal;
    vTex = texCoord * repeat;

    gl_Position = projection * p;
}
