#version 330 core
#define POINT_LIGHTS 5
#define SPOT_LIGHTS 2

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

struct PointLight {
    vec3 pos;
    vec3 color;
};

struct SpotLight {
    vec3 pos;
    vec3 color;
    vec3 dir;
    float cosInnen;
    float cosAussen;
};

uniform mat4 model;
uniform mat4 view;
uniform mat4 proj;
uniform vec2 tcMultiplier;

uniform PointLight pointLight[POINT_LIGHTS];
uniform SpotLight spotLight[SPOT_LIGHTS];

out vec2 texcoord;
out vec3 normale;
out vec3 toCamera;
out vec3 toPointLight[POINT_LIGHTS];
out vec3 toSpotLight[SPOT_LIGHTS];

vec3 toLight(vec3 lightPos, vec4 vertexPos) {
    return (view * vec4(lightPos, 1.0) - vertexPos).xyz;
}

void main() {
    vec4 viewPos = view * model * vec4(position, 1.0);

    toCamera = -viewPos.xyz;
    // wird nur gleichmaessig skaliert, normalize() passiert im Fragment Shader
    normale = mat3(view) * mat3(model) * normal;
    texcoord = tcMultiplier * texCoord;

    for (int i = 0; i < POINT_LIGHTS; i++) {
        toPointLight[i] = toLight(pointLight[i].pos, viewPos);
    }
    for (int i = 0; i < SPOT_LIGHTS; i++) {
        toSpotLight[i] = toLight(spotLight[i].pos, viewPos);
    }

    gl_Position = proj * viewPos;
}
