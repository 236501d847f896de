#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texcoord;
layout(location = 2) in vec3 normal;

// Matrizen
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;

// Positionen der Lichter (Weltkoordinaten)
uniform vec3 punktPosition;
uniform vec3 spotPosition;
uniform vec3 ecke1Position;
uniform vec3 ecke2Position;
uniform vec3 ecke3Position;
uniform vec3 ecke4Position;

out struct VertexData {
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
    vec3 toLightPunkt;
    vec3 toLightSpot;
    vec3 toLightEcke1;
    vec3 toLightEcke2;
    vec3 toLightEcke3;
    vec3 toLightEcke4;
} vertexData;

void main() {
    mat4 modelview = view_matrix * model_matrix;
    vec4 viewPosition = modelview * vec4(position, 1.0);
    mat4 normalMatrix = transpose(inverse(modelview));

    vertexData.tc = texcoord * tcMultiplier;
    vertexData.normal = (normalMatrix * vec4(normal, 0.0)).xyz;

    // erst im Fragment-Shader normalisieren!
    vertexData.toCamera = -viewPosition.xyz;
    vertexData.toLightPunkt = (view_matrix * vec4(punktPosition, 1.0) - viewPosition).xyz;
    vertexData.toLightSpot = (view_matrix * vec4(spotPosition, 1.0) - viewPosition).xyz;
    vertexData.toLightEcke1 = (view_matrix * vec4(ecke1Position, 1.0) - viewPosition).xyz;
    vertexData.toLightEcke2 = (view_matrix * vec4(ecke2Position, 1.0) - viewPosition).xyz;
    vertexData.toLightEcke3 = (view_matrix * vec4(ecke3Position, 1.0) - viewPosition).xyz;
    vertexData.toLightEcke4 = (view_matrix * vec4(ecke4Position, 1.0) - viewPosition).xyz;

    gl_Position = projection_matrix * viewPosition;
}
