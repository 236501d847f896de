#version 330 core

in struct VertexData {
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

// Material
uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D specular;
uniform float shininess;
uniform vec3 emissionFarbe;

// Punktlicht
uniform vec3 punktFarbe;
uniform vec3 punktK;

// Spotlight, Richtung im Viewspace, Winkel als Radiant
uniform vec3 spotFarbe;
uniform vec3 spotK;
uniform vec3 spotRichtung;
uniform float spotGamma;
uniform float spotPhi;

// Ecken
uniform vec3 ecke1Farbe;
uniform vec3 ecke1K;
uniform vec3 ecke2Farbe;
uniform vec3 ecke2K;
uniform vec3 ecke3Farbe;
uniform vec3 ecke3K;
uniform vec3 ecke4Farbe;
uniform vec3 ecke4K;

const vec3 L_a = vec3(0.02);

out vec4 color;

// Term C
vec3 diffuse(vec3 N, vec3 L, vec3 M_d) {
    float cosAlpha = max(0.0, dot(N, L));
    return M_d * cosAlpha;
}

// Term D mit Half-Vector (4.7)
vec3 spiegelung(vec3 N, vec3 L, vec3 V, vec3 M_s) {
    vec3 H = normalize(L + V);
    float cosBeta = max(0.0, dot(N, H));
    return M_s * pow(cosBeta, shininess);
}

// Lightattenuation (4.3.4)
vec3 abschwaechen(vec3 farbe, vec3 K, vec3 toLight) {
    float d = length(toLight);
    float F_att = 1.0 / (K.x + K.y * d + K.z * d * d);
    return farbe * F_att;
}

// Intensitaet des Spotlights
float intensitaet(vec3 L, vec3 richtung) {
    float cosTheta = dot(L, -normalize(richtung));
    float cosGamma = cos(spotGamma);
    float cosPhi = cos(spotPhi);
    return clamp((cosTheta - cosPhi) / (cosGamma - cosPhi), 0.0, 1.0);
}

void main() {
    vec3 M_e = texture(emit, vertexData.tc).rgb;
    vec3 M_d = texture(diff, vertexData.tc).rgb;
    vec3 M_s = texture(specular, vertexData.tc).rgb;

    vec3 N = normalize(vertexData.normal);
    vec3 V = normalize(vertexData.toCamera);

    // Term A und B
    vec3 ergebnis = M_e * emissionFarbe + M_d * L_a;

    // Punktlicht
    vec3 L = normalize(vertexData.toLightPunkt);
    vec3 L_i = abschwaechen(punktFarbe, punktK, vertexData.toLightPunkt);
    ergebnis += (diffuse(N, L, M_d) + spiegelung(N, L, V, M_s)) * L_i;

    // Spotlight
    L = normalize(vertexData.toLightSpot);
    L_i = abschwaechen(spotFarbe, spotK, vertexData.toLightSpot);
    L_i *= intensitaet(L, spotRichtung);
    ergebnis += (diffuse(N, L, M_d) + spiegelung(N, L, V, M_s)) * L_i;

    // Ecke 1
    L = normalize(vertexData.toLightEcke1);
    L_i = abschwaechen(ecke1Farbe, ecke1K, vertexData.toLightEcke1);
    ergebnis += (diffuse(N, L, M_d) + spiegelung(N, L, V, M_s)) * L_i;

    // Ecke 2
    L = normalize(vertexData.toLightEcke2);
    L_i = abschwaechen(ecke2Farbe, ecke2K, vertexData.toLightEcke2);
    ergebnis += (diffuse(N, L, M_d) + spiegelung(N, L, V, M_s)) * L_i;

    // Ecke 3
    L = normalize(vertexData.toLightEcke3);
    L_i = abschwaechen(ecke3Farbe, ecke3K, vertexData.toLightEcke3);
    ergebnis += (diffuse(N, L, M_d) + spiegelung(N, L, V, M_s)) * L_i;

    // Ecke 4
    L = normalize(vertexData.toLightEcke4);
    L_i = abschwaechen(ecke4Farbe, ecke4K, vertexData.toLightEcke4);
    ergebnis += (diffuse(N, L, M_d) + spiegelung(N, L, V, M_s)) * L_i;

    color = vec4(ergebnis, 1.0);
}
