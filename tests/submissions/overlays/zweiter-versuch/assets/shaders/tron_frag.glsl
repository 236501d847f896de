#version 330 core

in vec2 texKoord;
in vec3 normale;
in vec3 zurKamera;
in vec3 zumLicht[5];
in vec3 zumSpot;

// Material
uniform sampler2D diffusTextur;
uniform sampler2D glanzTextur;
uniform sampler2D leuchtTextur;
uniform float glanzExponent;
uniform vec3 leuchtfarbe;

// alle Punktlichter, 0 ist das vom Motorrad
uniform vec3 lichtFarbe[5];

// Scheinwerfer
uniform vec3 spotFarbe;
uniform vec3 spotRichtung;
uniform float spotCosInnen;
uniform float spotCosAussen;

out vec4 fragColor;

const float AMBIENT = 0.01;

// ---- Gamma (neu dieses Jahr) ----
vec3 zuLinear(vec3 c) {
    return pow(c, vec3(2.2));
}

vec3 zuGamma(vec3 c) {
    return pow(c, vec3(1.0 / 2.2));
}

// ---- 4.3.4, alt: 1.0 / (k.x + k.y * d + k.z * d * d) ----
float daempfung(vec3 weg) {
    float d = length(weg);
    return 1.0 / (d * d);
}

// ---- 4.2 ----
float diffusAnteil(vec3 N, vec3 L) {
    return max(dot(N, L), 0.0);
}

// ---- 4.7, vorher Phong:
//   vec3 R = reflect(-L, N);
//   return pow(max(dot(R, V), 0.0), glanzExponent);
float glanzAnteil(vec3 N, vec3 L, vec3 V) {
    vec3 H = normalize(L + V);
    return pow(max(dot(N, H), 0.0), glanzExponent);
}

// ---- 4.3 ----
float spotIntensitaet(vec3 L) {
    float theta = dot(-L, normalize(spotRichtung));
    float I = (theta - spotCosAussen) / (spotCosInnen - spotCosAussen);
    return clamp(I, 0.0, 1.0);
}

void main() {
    vec3 N = normalize(normale);
    vec3 V = normalize(zurKamera);

    // Summen ueber alle Lichter, das Material kommt erst am Schluss dazu
    vec3 diffusLicht = vec3(AMBIENT);
    vec3 glanzLicht = vec3(0.0);

    // Motorrad + Ecken
    for (int i = 0; i < 5; i++) {
        vec3 L = normalize(zumLicht[i]);
        vec3 ankommend = lichtFarbe[i] * daempfung(zumLicht[i]);
        diffusLicht += diffusAnteil(N, L) * ankommend;
        glanzLicht += glanzAnteil(N, L, V) * ankommend;
    }

    // Scheinwerfer extra
    vec3 Ls = normalize(zumSpot);
    vec3 spotLicht = spotFarbe * spotIntensitaet(Ls) * daempfung(zumSpot);
    diffusLicht += diffusAnteil(N, Ls) * spotLicht;
    glanzLicht += glanzAnteil(N, Ls, V) * spotLicht;

    vec3 Md = zuLinear(texture(diffusTextur, texKoord).rgb);
    vec3 Ms = texture(glanzTextur, texKoord).rgb;
    vec3 Me = zuLinear(texture(leuchtTextur, texKoord).rgb);

    vec3 ergebnis = Me * leuchtfarbe + Md * diffusLicht + Ms * glanzLicht;
    // fragColor = vec4(ergebnis, 1.0);
    fragColor = vec4(zuGamma(ergebnis), 1.0);
}
