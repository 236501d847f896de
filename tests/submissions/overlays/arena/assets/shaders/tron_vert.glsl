#version 330 core
#define LIGHTS 6

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texcoord;
layout(location = 2) in vec3 normal;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;

uniform PointLight pointLights[LIGHTS];
uniform vec3 spotPosition;

out VertexData {
    vec2 texcoord;
    vec3 normal;
    vec3 toCamera;
    vec3 toSpot;
    vec3 toLight[LIGHTS];
} vertexData;

void main() {
    mat4 modelview = view_matrix * model_matrix;
    vec4 pos = modelview * vec4(position, 1.0f);
    gl_Position = projection_matrix * pos;

    vertexData.texcoord = texcoord * tcMultiplier;
    // die Wände sind in jede Richtung anders skaliert, deshalb inverse-transpose
    vertexData.normal = (inverse(transpose(modelview)) * vec4(normal, 0.0f)).xyz;
    vertexData.toCamera = -pos.xyz;

    vec4 sp = view_matrix * vec4(spotPosition, 1.0f);
    vertexData.toSpot = (sp - pos).xyz;
    for (int i = 0; i < LIGHTS; i++) {
        vec4 lp = view_matrix * vec4(pointLights[i].position, 1.0f);
        vertexData.toLight[i] = (lp - pos).xyz;
    }
}
