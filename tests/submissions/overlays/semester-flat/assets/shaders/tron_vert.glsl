#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

// Matrizen
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;

// Lichtpositionen (Welt)
uniform vec3 bikeLight_position;
uniform vec3 frontSpot_position;
uniform vec3 light1_position;
uniform vec3 light2_position;
uniform vec3 light3_position;

out vec2 uv;
out vec3 normalVS;
out vec3 toCamera;
out vec3 toBikeLight;
out vec3 toFrontSpot;
out vec3 toLight1;
out vec3 toLight2;
out vec3 toLight3;

void main() {
    vec4 pos = view * model * vec4(position, 1.0);
    gl_Position = projection * pos;

    uv = texCoord;
    // nur gleichmaessig skaliert, daher reicht mat3
    normalVS = mat3(view * model) * normal;

    toCamera = vec3(0.0) - pos.xyz;

    vec4 bikePos = view * vec4(bikeLight_position, 1.0);
    toBikeLight = (bikePos - pos).xyz;
    vec4 spotPos = view * vec4(frontSpot_position, 1.0);
    toFrontSpot = spotPos.xyz - pos.xyz;
    vec4 pos1 = view * vec4(light1_position, 1.0);
    toLight1 = (pos1 - pos).xyz;
    vec4 pos2 = view * vec4(light2_position, 1.0);
    toLight2 = (pos2 - pos).xyz;
    vec4 pos3 = view * vec4(light3_position, 1.0);
    toLight3 = (pos3 - pos).xyz;
}
