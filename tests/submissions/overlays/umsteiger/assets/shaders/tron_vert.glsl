#version 330 core

const int LIGHTS = 6;

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec2 aTexCoord;
layout(location = 2) in vec3 aNormal;

uniform mat4 uModel;
uniform mat4 uView;
uniform mat4 uProjection;
uniform vec2 uTcMultiplier;
uniform vec3 uLightPosition[LIGHTS];

out vec2 vTexCoord;
out vec3 vNormal;
out vec3 vToCamera;
out vec3 vToLight[LIGHTS];

void main() {
    vec4 worldPos = uModel * vec4(aPosition, 1.0);
    vec4 viewPos = uView * worldPos;
    gl_Position = uProjection * viewPos;

    vTexCoord = aTexCoord * uTcMultiplier;
    vNormal = mat3(uView) * mat3(uModel) * aNormal; // the scale is uniform
    vToCamera = vec3(0.0) - viewPos.xyz;
    for (int i = 0; i < LIGHTS; i++) {
        vec4 lightPos = uView * vec4(uLightPosition[i], 1.0);
        vToLight[i] = lightPos.xyz - viewPos.xyz;
    }
}
