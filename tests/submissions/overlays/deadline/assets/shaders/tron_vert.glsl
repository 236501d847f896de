#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normale;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;

uniform vec3 lightPos;
uniform vec3 spot_lightPos;
uniform vec3 ecke1_lightPos;
uniform vec3 ecke2_lightPos;
uniform vec3 ecke3_lightPos;
uniform vec3 ecke4_lightPos;

out vec2 tc;
out vec3 normal;
out vec3 toCamera;
out vec3 toLight1;
out vec3 toLight2;
out vec3 toLight3;
out vec3 toLight4;
out vec3 toLight5;
out vec3 toLight6;

void main() {
    gl_Position = projection_matrix * view_matrix * model_matrix * vec4(position, 1.0f);
    tc = texCoord * tcMultiplier;
    normal = mat3(transpose(inverse(view_matrix * model_matrix))) * normale;

    // alles im Viewspace
    vec4 P = view_matrix * model_matrix * vec4(position, 1.0f);
    toCamera = -P.xyz;

    vec4 lp1 = view_matrix * vec4(lightPos, 1.0f);
    toLight1 = (lp1 - P).xyz;
    // Spot
    vec4 lp2 = view_matrix * vec4(spot_lightPos, 1.0f);
    toLight2 = (lp2 - P).xyz;
    // Ecken
    vec4 lp3 = view_matrix * vec4(ecke1_lightPos, 1.0f);
    toLight3 = (lp3 - P).xyz;
    vec4 lp4 = view_matrix * vec4(ecke2_lightPos, 1.0f);
    toLight4 = (lp4 - P).xyz;
    vec4 lp5 = view_matrix * vec4(ecke3_lightPos, 1.0f);
    toLight5 = (lp5 - P).xyz;
    vec4 lp6 = view_matrix * vec4(ecke4_lightPos, 1.0f);
    toLight6 = (lp6 - P).xyz;
}
