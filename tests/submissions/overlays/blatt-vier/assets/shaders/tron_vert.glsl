#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 tc;
layout(location = 2) in vec3 normal;

// Transformationsmatrizen
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;

uniform vec2 tcMultiplier;

// Lichtpositionen (Weltkoordinaten)
uniform vec3 pointLightPos;
uniform vec3 spotLightPos;
// Aufgabe 4.6
uniform vec3 eckLightPos[4];

out struct VertexData
{
    vec3 position;
    vec2 texcoord;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight;
    vec3 toSpotLight;
} vertexData;

out vec3 toEckLight[4];

void main() {
    mat4 modelView = view_matrix * model_matrix;
    vec4 viewPos = modelView * vec4(position, 1.0f);

    // Normale in den Viewspace
    vec4 norm = inverse(transpose(modelView)) * vec4(normal, 0.0f);
    vertexData.normal = norm.xyz;

    vertexData.position = viewPos.xyz;
    vertexData.texcoord = tc * tcMultiplier;

    // Kamera sitzt im Viewspace im Ursprung
    vertexData.toCamera = -viewPos.xyz;

    // Punktlicht
    vec4 lp = view_matrix * vec4(pointLightPos, 1.0f);
    vertexData.toPointLight = (lp - viewPos).xyz;

    // Scheinwerfer
    vec4 sp = view_matrix * vec4(spotLightPos, 1.0f);
    vertexData.toSpotLight = (sp - viewPos).xyz;

    // Ecken
    for (int i = 0; i < 4; i++) {
        vec4 ep = view_matrix * vec4(eckLightPos[i], 1.0f);
        toEckLight[i] = (ep - viewPos).xyz;
    }

    //gl_Position = proj_matrix * view_matrix * model_matrix * vec4(position, 1.0f);
    gl_Position = proj_matrix * viewPos;
}
