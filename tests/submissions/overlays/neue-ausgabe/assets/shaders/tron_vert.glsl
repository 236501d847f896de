#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 textureCoords;
layout(location = 2) in vec3 normal;

uniform mat4 modelMatrix;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec2 textureScale;

// Lichter vom Motorrad (World Space)
uniform vec3 pointLightPosition;
uniform vec3 spotLightPosition;

// alles im View Space
out vec3 fragPosition;
out vec3 fragNormal;
out vec2 fragTexCoords;
out vec3 toCamera;
out vec3 toPointLight;
out vec3 toSpotLight;

void main() {
    mat4 modelView = viewMatrix * modelMatrix;
    vec4 viewPosition = modelView * vec4(position, 1.0);

    fragPosition = viewPosition.xyz;
    fragNormal = mat3(transpose(inverse(modelView))) * normal;
    fragTexCoords = textureCoords * textureScale;

    toCamera = -viewPosition.xyz;
    toPointLight = (viewMatrix * vec4(pointLightPosition, 1.0) - viewPosition).xyz;
    toSpotLight = (viewMatrix * vec4(spotLightPosition, 1.0) - viewPosition).xyz;

    gl_Position = projectionMatrix * viewPosition;
}
