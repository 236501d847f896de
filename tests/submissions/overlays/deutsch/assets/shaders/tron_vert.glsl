#version 330 core

layout(location = 0) in vec3 pos;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec3 nrm;

#define ANZAHL 5

// Matrizen
uniform mat4 modelMatrix;
uniform mat4 viewMatrix;
uniform mat4 projMatrix;
uniform vec2 tcMultiplier;

// Lichter (Weltkoordinaten)
uniform vec3 lichtPos[ANZAHL];
uniform vec3 strahlerPos;

out vec2 texKoord;
out vec3 normale;
out vec3 toCamera;
out vec3 toLight[ANZAHL];
out vec3 toStrahler;

void main() {
    // Vertex in den Viewspace
    vec4 p = viewMatrix * modelMatrix * vec4(pos, 1.0f);
    // Normale: Inverse Transponierte
    normale = (inverse(transpose(viewMatrix * modelMatrix)) * vec4(nrm, 0.0f)).xyz;
    texKoord = uv * tcMultiplier;

    toCamera = -p.xyz;
    for (int i = 0; i < ANZAHL; ++i) {
        vec4 lp = viewMatrix * vec4(lichtPos[i], 1.0f);
        toLight[i] = (lp - p).xyz;
    }
    vec4 sp = viewMatrix * vec4(strahlerPos, 1.0f);
    toStrahler = (sp - p).xyz;

    gl_Position = projMatrix * p;
}
