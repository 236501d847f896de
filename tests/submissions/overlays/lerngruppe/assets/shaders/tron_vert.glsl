#version 330 core

// ======================================================================
// Blatt 4, Vertex Shader (Lerngruppe Mittwoch)
//
// Ausgaben heissen wie in der Vorlesung (Kapitel 5, Folie 12):
//   N  Normale
//   V  Vektor zum Betrachter
//   L  Vektor zum Licht
//   R  gespiegeltes L  -> gibt es bei uns nur im FS, seit 4.7 gar nicht mehr
//   T  Texturkoordinate
//
// Alles im View Space. NICHT normalisieren: beim Interpolieren zwischen den
// Ecken werden die Vektoren wieder kuerzer, und die Laenge von L ist unser d.
// ======================================================================

#define TOWERS 4

struct LightSource {
    vec3 worldPosition;
    vec3 rgb;
    vec3 kFactors;      // (K_c, K_l, K_q)
};

layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec2 vertexTexture;
layout(location = 2) in vec3 vertexNormal;

uniform mat4 objectToWorld;
uniform mat4 worldToView;
uniform mat4 viewToClip;
uniform vec2 textureRepeat;

uniform LightSource halo;               // 4.2 haengt ueber dem Motorrad
uniform LightSource beam;               // 4.3 Scheinwerfer
uniform LightSource tower[TOWERS];      // 4.6 Ecken

out vec3 N;
out vec3 V;
out vec2 T;
out vec3 L_halo;
out vec3 L_beam;
out vec3 L_tower[TOWERS];

// Formel 2.4 aus Kapitel 3: M_mv = M_view * M_model
mat4 modelView() {
    return worldToView * objectToWorld;
}

// Formel 3.2 aus Kapitel 5: N' = (M^-1)^T * N
vec3 computeN() {
    mat3 M = mat3(modelView());
    return transpose(inverse(M)) * vertexNormal;
}

// Kamera sitzt im View Space in (0,0,0), also V = 0 - P
vec3 computeV(vec3 P) {
    return -P;
}

// L = Lichtposition - P, beide im View Space
vec3 computeL(LightSource light, vec3 P) {
    vec4 lightInView = worldToView * vec4(light.worldPosition, 1.0);
    return lightInView.xyz - P;
}

void main() {
    vec4 P = modelView() * vec4(vertexPosition, 1.0);

    N = computeN();
    V = computeV(P.xyz);
    T = vertexTexture * textureRepeat;

    L_halo = computeL(halo, P.xyz);
    L_beam = computeL(beam, P.xyz);
    for (int i = 0; i < TOWERS; i++)
        L_tower[i] = computeL(tower[i], P.xyz);

    gl_Position = viewToClip * P;
}
