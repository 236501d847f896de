#version 330 core

// Blatt 4 - Fragment Shader
//
//   L_o = A + B + Summe ( (C + D) * L_i )
//
//   A = M_e    B = M_d * L_a    C = M_d * max(cos alpha, 0)    D = M_s * max(cos beta, 0)^k

in vec2 tc;
in vec3 normale;
in vec3 toCamera;
in vec3 toLight_moto;
in vec3 toLight_spot;
in vec3 toLight_ecke[4];

// Material
uniform sampler2D map_e;
uniform sampler2D map_d;
uniform sampler2D map_s;
uniform float k;
uniform vec3 farbe_e;       // 4.4

// Punktlicht am Motorrad
uniform vec3 L_moto;
uniform vec3 K_moto;        // (K_c, K_l, K_q)

// Ecken (4.6)
uniform vec3 L_ecke[4];
uniform vec3 K_ecke[4];

// Scheinwerfer
uniform vec3 L_spot;
uniform vec3 K_spot;
uniform vec3 D_spot;        // Richtung, schon im View Space
uniform float gamma_spot;   // innen (rad)
uniform float phi_spot;     // aussen (rad)

out vec4 fragColor;

const vec3 L_a = vec3(0.02);

vec3 M_e;
vec3 M_d;
vec3 M_s;

// Emission
vec3 A() {
    return M_e * farbe_e;
}

// ambient
vec3 B() {
    return M_d * L_a;
}

// diffus
vec3 C(vec3 N, vec3 L) {
    float cos_alpha = max(dot(N, L), 0.0);
    return M_d * cos_alpha;
}

// spekular, mit Half-Vector (4.7)
vec3 D(vec3 N, vec3 L, vec3 V) {
    vec3 H = normalize(L + V);
    float cos_beta = max(dot(N, H), 0.0);
    return M_s * pow(cos_beta, k);
}

// alte Version von D vor 4.7
/*
vec3 D(vec3 N, vec3 L, vec3 V) {
    vec3 R = 2.0 * dot(N, L) * N - L;
    return M_s * pow(max(dot(R, V), 0.0), k);
}
*/

// Lichtabschwaechung, d = Abstand zum Licht
float F_att(vec3 K, float d) {
    return 1.0 / (K.x + K.y * d + K.z * d * d);
}

// Intensitaet vom Scheinwerfer: 1 im inneren Kegel, 0 ausserhalb vom aeusseren
// (Tutor: auf dem Blatt sind phi und gamma in der Formel vertauscht!)
float I_spot(vec3 L) {
    float cos_theta = dot(-L, normalize(D_spot));
    float cos_gamma = cos(gamma_spot);
    float cos_phi = cos(phi_spot);
    return clamp((cos_theta - cos_phi) / (cos_gamma - cos_phi), 0.0, 1.0);
}

void main() {
    M_e = texture(map_e, tc).rgb;
    M_d = texture(map_d, tc).rgb;
    M_s = texture(map_s, tc).rgb;

    vec3 N = normalize(normale);
    vec3 V = normalize(toCamera);

    vec3 L_o = A() + B();

    // Punktlicht
    vec3 L = normalize(toLight_moto);
    L_o += (C(N, L) + D(N, L, V)) * L_moto * F_att(K_moto, length(toLight_moto));

    // Ecken
    for (int i = 0; i < 4; i++) {
        L = normalize(toLight_ecke[i]);
        L_o += (C(N, L) + D(N, L, V)) * L_ecke[i] * F_att(K_ecke[i], length(toLight_ecke[i]));
    }

    // Scheinwerfer
    L = normalize(toLight_spot);
    L_o += (C(N, L) + D(N, L, V)) * I_spot(L) * L_spot * F_att(K_spot, length(toLight_spot));

    fragColor = vec4(L_o, 1.0);
}
