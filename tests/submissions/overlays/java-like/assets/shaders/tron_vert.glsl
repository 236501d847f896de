#version 330 core

const int LIGHT_COUNT = 6;

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec2 inTexCoord;
layout(location = 2) in vec3 inNormal;

uniform mat4 modelMatrix;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec2 textureRepeat;

// everything for the light is in world space
uniform vec3 cameraPosition;
uniform vec3 lightPosition[LIGHT_COUNT];

out vec2 texCoord;
out vec3 worldNormal;
out vec3 toView;
out vec3 toLight[LIGHT_COUNT];

void main() {
    vec4 worldPosition = modelMatrix * vec4(inPosition, 1.0);
    texCoord = inTexCoord * textureRepeat;
    worldNormal = transpose(inverse(mat3(modelMatrix))) * inNormal;
    toView = cameraPosition - worldPosition.xyz;
    for (int i = 0; i < LIGHT_COUNT; i++) {
        toLight[i] = lightPosition[i] - worldPosition.xyz;
    }
    gl_Position = projectionMatrix * viewMatrix * worldPosition;
}
