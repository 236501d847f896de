#version 330 core

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec2 inTexCoord;
layout(location = 2) in vec3 inNormal;

// Aufgabe 4.2
struct PointLight {
    vec3 position;      // world space!
    vec3 color;
    vec3 attenuation;   // x = Kc, y = Kl, z = Kq
};

// Aufgabe 4.3
struct SpotLight {
    vec3 position;      // world space!
    vec3 color;
    vec3 attenuation;
    vec3 direction;     // view space
    float innerAngle;
    float outerAngle;
};

uniform mat4 modelMatrix;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec2 textureScale;

uniform PointLight bikeLight;
uniform SpotLight headLight;

out vec3 viewPosition;
out vec3 viewNormal;
out vec2 texCoord;
out vec3 toCamera;
out vec3 toBikeLight;
out vec3 toHeadLight;

void main() {
    mat4 modelView = viewMatrix * modelMatrix;
    vec4 pos = modelView * vec4(inPosition, 1.0);

    viewPosition = pos.xyz;
    viewNormal = mat3(transpose(inverse(modelView))) * inNormal;
    texCoord = inTexCoord * textureScale;

    // Vektoren im Viewspace, normalisiert wird erst im Fragment Shader
    toCamera = -pos.xyz;
    toBikeLight = (viewMatrix * vec4(bikeLight.position, 1.0)).xyz - pos.xyz;
    toHeadLight = (viewMatrix * vec4(headLight.position, 1.0)).xyz - pos.xyz;

    gl_Position = projectionMatrix * pos;
}
