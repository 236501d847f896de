#version 330 core
#define LIGHTS 8

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

struct PointLight {
    vec3 pos;
    vec3 col;
    vec3 att;
};

struct SpotLight {
    vec3 pos;
    vec3 col;
    vec3 att;
    vec3 dir;
    float inner;
    float outer;
};

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;
uniform PointLight pointLight[LIGHTS];
uniform SpotLight spotLight;

out vec2 uv;
out vec3 normalVS;
out vec3 toCamera;
out vec3 toPoint[LIGHTS];
out vec3 toSpot;

void main() {
    mat4 mv = view_matrix * model_matrix;
    vec4 posVS = mv * vec4(position, 1.0);
    gl_Position = projection_matrix * posVS;

    uv = texCoord * tcMultiplier;
    normalVS = (transpose(inverse(mv)) * vec4(normal, 0.0)).xyz;
    toCamera = -posVS.xyz;

    for (int i = 0; i < LIGHTS; i++) {
        toPoint[i] = (view_matrix * vec4(pointLight[i].pos, 1.0) - posVS).xyz;
    }
    toSpot = (view_matrix * vec4(spotLight.pos, 1.0) - posVS).xyz;
}
