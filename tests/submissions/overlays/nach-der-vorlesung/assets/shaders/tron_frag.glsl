#version 330 core

// Erweitertes Phong-Modell (Vorlesung / Blatt 4.1):
//
//   L_o = M_e + M_d * L_a + Summe( ( M_d * max(cos alpha, 0) + M_s * max(cos beta, 0)^k ) * L_i )
//
// Alle Vektoren im Viewspace.

in vec3 vP;
in vec3 vN;
in vec2 vTc;

struct Punktlicht {
    vec3 pos;       // Weltkoordinaten
    vec3 col;
    vec3 att;       // (K_c, K_l, K_q)
};

struct Scheinwerfer {
    vec3 pos;       // Weltkoordinaten
    vec3 col;
    vec3 att;
    vec3 dir;       // schon im Viewspace
    float gamma;    // innerer Kegel
    float phi;      // aeusserer Kegel
};

uniform mat4 uView;

// Material
uniform sampler2D uMd;
uniform sampler2D uMs;
uniform sampler2D uMe;
uniform float uShininess;
uniform vec3 uEmitCol;

// Lichter am Motorrad
uniform Punktlicht uPoint;
uniform Scheinwerfer uSpot;

// 4.6: weitere Lichter
uniform vec3 uLightPos1;
uniform vec3 uLightCol1;
uniform vec3 uAtt1;

uniform vec3 uLightPos2;
uniform vec3 uLightCol2;
uniform vec3 uAtt2;

uniform vec3 uLightPos3;
uniform vec3 uLightCol3;
uniform vec3 uAtt3;

out vec4 fragColor;

// F_att = 1.0 / (K_c + K_l * d + K_q * d^2)
float F_att(vec3 K, float d) {
    float K_c = K.x;
    float K_l = K.y;
    float K_q = K.z;
    return 1.0 / (K_c + K_l * d + K_q * d * d);
}

void main() {
    // Materialwerte
    vec3 M_d = texture(uMd, vTc).rgb;
    vec3 M_s = texture(uMs, vTc).rgb;
    vec3 M_e = texture(uMe, vTc).rgb * uEmitCol;    // 4.4
    float k = uShininess;

    // N: Normale, V: vom Punkt zur Kamera (die liegt im Viewspace im Ursprung)
    vec3 N = normalize(vN);
    vec3 V = normalize(-vP);

    // Term A und B
    vec3 L_a = vec3(0.03);
    vec3 L_o = M_e + M_d * L_a;

    vec3 L;             // vom Punkt zum Licht
    vec3 H;             // Half-Vector (4.7)
    vec3 L_i;           // ankommendes Licht
    float d;            // Abstand zum Licht
    float cosAlpha;     // Winkel zwischen N und L
    float cosBeta;      // Winkel zwischen N und H

    // ----- Punktlicht -----
    L = (uView * vec4(uPoint.pos, 1.0)).xyz - vP;
    d = length(L);
    L = normalize(L);
    // vec3 R = reflect(-L, N);
    // cosBeta = max(dot(R, V), 0.0);
    H = normalize(L + V);
    cosAlpha = max(dot(N, L), 0.0);
    cosBeta = max(dot(N, H), 0.0);
    L_i = uPoint.col * F_att(uPoint.att, d);
    L_o += (M_d * cosAlpha + M_s * pow(cosBeta, k)) * L_i;

    // ----- Scheinwerfer -----
    L = (uView * vec4(uSpot.pos, 1.0)).xyz - vP;
    d = length(L);
    L = normalize(L);
    H = normalize(L + V);
    cosAlpha = max(dot(N, L), 0.0);
    cosBeta = max(dot(N, H), 0.0);
    // I = (cos theta - cos gamma) / (cos phi - cos gamma)
    // (auf dem Blatt muss dafuer gamma aussen und phi innen sein, hier wie im Text: gamma innen)
    float cosTheta = dot(-L, normalize(uSpot.dir));
    float cosGamma = cos(uSpot.gamma);
    float cosPhi = cos(uSpot.phi);
    float I = clamp((cosTheta - cosPhi) / (cosGamma - cosPhi), 0.0, 1.0);
    L_i = uSpot.col * I * F_att(uSpot.att, d);
    L_o += (M_d * cosAlpha + M_s * pow(cosBeta, k)) * L_i;

    // ----- Licht 1 -----
    L = (uView * vec4(uLightPos1, 1.0)).xyz - vP;
    d = length(L);
    L = normalize(L);
    H = normalize(L + V);
    cosAlpha = max(dot(N, L), 0.0);
    cosBeta = max(dot(N, H), 0.0);
    L_i = uLightCol1 * F_att(uAtt1, d);
    L_o += (M_d * cosAlpha + M_s * pow(cosBeta, k)) * L_i;

    // ----- Licht 2 -----
    L = (uView * vec4(uLightPos2, 1.0)).xyz - vP;
    d = length(L);
    L = normalize(L);
    H = normalize(L + V);
    cosAlpha = max(dot(N, L), 0.0);
    cosBeta = max(dot(N, H), 0.0);
    L_i = uLightCol2 * F_att(uAtt2, d);
    L_o += (M_d * cosAlpha + M_s * pow(cosBeta, k)) * L_i;

    // ----- Licht 3 -----
    L = (uView * vec4(uLightPos3, 1.0)).xyz - vP;
    d = length(L);
    L = normalize(L);
    H = normalize(L + V);
    cosAlpha = max(dot(N, L), 0.0);
    cosBeta = max(dot(N, H), 0.0);
    L_i = uLightCol3 * F_att(uAtt3, d);
    L_o += (M_d * cosAlpha + M_s * pow(cosBeta, k)) * L_i;

    fragColor = vec4(L_o, 1.0);
}
