#version 330 core

// ======================================================================
// Blatt 4, Fragment Shader (Lerngruppe Mittwoch)
//
// Formel vom Blatt (4.1):
//   L_O = M_e + M_d * L_a + SUMME_i (M_d * cos(alpha) + M_s * cos(beta)^k) * L_i
//         --A-   ----B----           -------C--------   -------D---------
// Jedes Symbol ist eine kleine Funktion, so hat es jeder von uns verstanden :)
// Grosse Buchstaben = kommt so an, kleine Buchstaben (n, v, l, h) = Laenge 1
// ======================================================================

#define TOWERS 4

struct LightSource {
    vec3 worldPosition;
    vec3 rgb;
    vec3 kFactors;      // (K_c, K_l, K_q)
};

in vec3 N;
in vec3 V;
in vec2 T;
in vec3 L_halo;
in vec3 L_beam;
in vec3 L_tower[TOWERS];

// Material
uniform sampler2D glowTexture;
uniform sampler2D paintTexture;
uniform sampler2D glossTexture;
uniform float glossExponent;            // k
uniform vec3 glowTint;                  // 4.4

// Licht
uniform vec3 surroundingLight;          // L_a
uniform LightSource halo;
uniform LightSource beam;
uniform LightSource tower[TOWERS];
uniform vec3 beamHeading;               // View Space
uniform vec2 beamCone;                  // (gamma, phi) in rad

out vec4 pixelColor;

// ---------- M: Material ----------

vec3 M_e() {
    return texture(glowTexture, T).rgb * glowTint;
}

vec3 M_d() {
    return texture(paintTexture, T).rgb;
}

vec3 M_s() {
    return texture(glossTexture, T).rgb;
}

// ---------- Winkel ----------

// Formel 5.1 aus Kapitel 5 (Lambert), max wegen 4.1.2
float cosAlpha(vec3 n, vec3 l) {
    return max(dot(n, l), 0.0);
}

// Formel 5.3 aus Kapitel 5 (Phong), bis 4.6
// float cosBeta(vec3 n, vec3 l, vec3 v) {
//     vec3 r = 2.0 * dot(n, l) * n - l;
//     return max(dot(r, v), 0.0);
// }

// Formel 5.5 aus Kapitel 5 (Blinn-Phong), h = Winkelhalbierende
float cosBeta(vec3 n, vec3 l, vec3 v) {
    vec3 h = normalize(l + v);
    return max(dot(n, h), 0.0);
}

// ---------- 4.3 ----------

// I = 1 innen (gamma), 0 aussen (phi)
float coneIntensity(vec3 l) {
    float cosTheta = dot(-l, normalize(beamHeading));
    float cosGamma = cos(beamCone.x);
    float cosPhi = cos(beamCone.y);
    return clamp((cosTheta - cosPhi) / (cosGamma - cosPhi), 0.0, 1.0);
}

// Nenner ist ein Skalarprodukt: (K_c, K_l, K_q) * (1, d, d^2)
float F_att(vec3 k, float d) {
    return 1.0 / dot(k, vec3(1.0, d, d * d));
}

// Was vom Licht hier ankommt
vec3 L_i(LightSource light, vec3 L) {
    return light.rgb * F_att(light.kFactors, length(L));
}

// ---------- C und D ----------

vec3 partC(vec3 n, vec3 l) {
    return M_d() * cosAlpha(n, l);
}

vec3 partD(vec3 n, vec3 l, vec3 v) {
    return M_s() * pow(cosBeta(n, l, v), glossExponent);
}

void main() {
    vec3 n = normalize(N);
    vec3 v = normalize(V);

    vec3 sum = vec3(0.0);

    // i = 1: Punktlicht am Motorrad
    vec3 l = normalize(L_halo);
    sum += (partC(n, l) + partD(n, l, v)) * L_i(halo, L_halo);

    // i = 2: Scheinwerfer
    vec3 l2 = normalize(L_beam);
    sum += (partC(n, l2) + partD(n, l2, v)) * L_i(beam, L_beam) * coneIntensity(l2);

    // i = 3..6: Ecken
    for (int i = 0; i < TOWERS; i++) {
        vec3 l3 = normalize(L_tower[i]);
        sum += (partC(n, l3) + partD(n, l3, v)) * L_i(tower[i], L_tower[i]);
    }

    // A + B + Summe
    vec3 L_O = M_e() + M_d() * surroundingLight + sum;
    pixelColor = vec4(L_O, 1.0);
}
