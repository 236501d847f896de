#version 330 core

#define NUM_POINT_LIGHTS 5

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
    float innerCone;
    float outerCone;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

//uniforms
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

uniform PointLight pointLights[NUM_POINT_LIGHTS];
uniform SpotLight spotLight;

out struct VertexData {
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
} vertexData;

out vec3 toPointLight[NUM_POINT_LIGHTS];
out vec3 toSpotLight;

void main() {
    mat4 modelView = view * model;
    mat4 normalMat = transpose(inverse(modelView));
    vec4 viewPos = modelView * vec4(position, 1.0f);

    for (int i = 0; i < NUM_POINT_LIGHTS; i++) {
        toPointLight[i] = (view * vec4(pointLights[i].position, 1.0f)).xyz - viewPos.xyz;
    }
    toSpotLight = (view * vec4(spotLight.position, 1.0f)).xyz - viewPos.xyz;

    vertexData.tc = texCoord * tcMultiplier;
    vertexData.normal = mat3(normalMat) * normal;
    vertexData.toCamera = -viewPos.xyz;

    gl_Position = projection * viewPos;
}
