#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texcoord;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

// Licht-Positionen (Welt)
uniform vec3 light1_pos;
uniform vec3 light2_pos;
uniform vec3 light3_pos;
uniform vec3 light4_pos;
uniform vec3 light5_pos;
uniform vec3 light6_pos;

out vec2 vTex;
out vec3 vNormal;
out vec3 toCamera;
out vec3 toLight1;
out vec3 toLight2;
out vec3 toLight3;
out vec3 toLight4;
out vec3 toLight5;
out vec3 toLight6;

void main() {
    gl_Position = projection * view * model * vec4(position, 1.0);
    vTex = texcoord * tcMultiplier;

    // Normale
    mat4 mv = view * model;
    vNormal = (transpose(inverse(mv)) * vec4(normal, 0.0)).xyz;

    // Kamera ist im View Space bei 0,0,0
    vec4 viewPos = view * model * vec4(position, 1.0);
    toCamera = vec3(0.0) - viewPos.xyz;

    // Lichter
    vec4 lp1 = view * vec4(light1_pos, 1.0);
    toLight1 = (lp1 - viewPos).xyz;
    vec4 lp2 = view * vec4(light2_pos, 1.0);
    toLight2 = (lp2 - viewPos).xyz;
    vec4 lp3 = view * vec4(light3_pos, 1.0);
    toLight3 = (lp3 - viewPos).xyz;
    vec4 lp4 = view * vec4(light4_pos, 1.0);
    toLight4 = (lp4 - viewPos).xyz;
    vec4 lp5 = view * vec4(light5_pos, 1.0);
    toLight5 = (lp5 - viewPos).xyz;
    vec4 lp6 = view * vec4(light6_pos, 1.0);
    toLight6 = (lp6 - viewPos).xyz;
}
