#version 330 core
#define NR_POINT_LIGHTS 6

layout (location = 0) in vec3 aPos;
layout (location = 1) in vec2 aTexCoords;
layout (location = 2) in vec3 aNormal;

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
    vec3 direction;
    float cutOff;
    float outerCutOff;
};

out VertexData {
    vec2 texCoords;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight[NR_POINT_LIGHTS];
    vec3 toSpotLight;
} vertexData;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;
uniform PointLight pointLights[NR_POINT_LIGHTS];
uniform SpotLight spotLight;

vec3 worldToView(vec3 point) {
    return vec3(view * vec4(point, 1.0));
}

void main() {
    vec3 worldPos = vec3(model * vec4(aPos, 1.0));
    vec3 fragPos = worldToView(worldPos);
    mat3 normalMatrix = mat3(transpose(inverse(view * model)));

    vertexData.texCoords = aTexCoords * tcMultiplier;
    vertexData.normal = normalMatrix * aNormal;
    vertexData.toCamera = vec3(0.0) - fragPos;
    for (int i = 0; i < NR_POINT_LIGHTS; i++) {
        vertexData.toPointLight[i] = worldToView(pointLights[i].position) - fragPos;
    }
    vertexData.toSpotLight = worldToView(spotLight.position) - fragPos;

    gl_Position = projection * vec4(fragPos, 1.0);
}
