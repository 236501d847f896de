#version 330 core

// Blatt 4 - Vertex Shader
// (Tafel im Tutorium: alles im View Space, normalisiert wird erst im Fragment Shader,
//  weil die Interpolation zwischen den Vertices die Laenge wieder kaputt macht)

layout(location = 0) in vec3 p_model;
layout(location = 1) in vec2 tc_model;
layout(location = 2) in vec3 n_model;

uniform mat4 mat_MV;    // View * Model
uniform mat4 mat_N;     // (MV^-1)^T
uniform mat4 mat_V;
uniform mat4 mat_P;
uniform vec2 kacheln;

// Lichtpositionen in Weltkoordinaten
uniform vec3 pos_moto;
uniform vec3 pos_spot;
uniform vec3 pos_ecke[4];

out vec2 tc;
out vec3 normale;
out vec3 toCamera;
out vec3 toLight_moto;
out vec3 toLight_spot;
out vec3 toLight_ecke[4];

// Vektor vom Vertex p (View Space) zum Licht
vec3 toLight(vec3 licht_welt, vec3 p) {
    vec3 licht_view = (mat_V * vec4(licht_welt, 1.0)).xyz;
    return licht_view - p;
}

void main() {
    vec3 p = (mat_MV * vec4(p_model, 1.0)).xyz;

    // Kamera = Ursprung
    toCamera = -p;

    toLight_moto = toLight(pos_moto, p);
    toLight_spot = toLight(pos_spot, p);
    for (int i = 0; i < 4; i++) {
        toLight_ecke[i] = toLight(pos_ecke[i], p);
    }

    normale = mat3(mat_N) * n_model;
    tc = kacheln * tc_model;

    gl_Position = mat_P * vec4(p, 1.0);
}
