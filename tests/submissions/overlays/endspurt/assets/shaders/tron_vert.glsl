#version 330 core

#define ANZAHL 5

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texture_coordinate;
layout(location = 2) in vec3 normal;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;

uniform vec3 pointLightPos[ANZAHL];
uniform vec3 spotLightPos;

out struct VertexData {
    vec3 toCamera;
    vec2 texture_coordinate;
    vec3 normal;
} vertexData;

out vec3 toPointLight[ANZAHL];
out vec3 toSpotLight;

void main() {
    mat4 modelView = view_matrix * model_matrix;
    vec4 pos = modelView * vec4(position, 1.0);
    gl_Position = projection_matrix * pos;

    vertexData.toCamera = -pos.xyz;
    vertexData.texture_coordinate = texture_coordinate * tcMultiplier;
    vertexData.normal = (inverse(transpose(modelView)) * vec4(normal, 0.0)).xyz;

    for (int i = 0; i < ANZAHL; i++) {
        vec4 lp = view_matrix * vec4(pointLightPos[i], 1.0);
        toPointLight[i] = (lp - pos).xyz;
    }
    vec4 sp = view_matrix * vec4(spotLightPos, 1.0);
    toSpotLight = (sp - pos).xyz;
}
