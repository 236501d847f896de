#version 330 core

// Blatt 4 - Fragmentshader
// Aufbau: fuer jeden Teil der Formel eine Funktion, in main() wird nur noch zusammengezaehlt.

#define ECKEN 4

// abfall = (Kc, Kl, Kq)
struct Licht {
    vec3 farbe;
    vec3 abfall;
};

// Winkel in Radiant, Achse in der Ansicht und Laenge 1
struct Kegel {
    vec3 achse;
    float innen;
    float aussen;
};

in vec2 uv;
in vec3 normale;
in vec3 blick;
in vec3 zuMotor;
in vec3 zuLampe;
in vec3 zuEcke[ECKEN];

// Material
uniform sampler2D farbTex;
uniform sampler2D glanzTex;
uniform sampler2D leuchtTex;
uniform float haerte;
uniform vec3 toenung;

// Lichter
uniform Licht motor;
uniform Licht lampe;
uniform Kegel kegel;
uniform Licht ecke[ECKEN];

out vec4 bildpunkt;

const float GAMMA = 2.2;
const vec3 UMGEBUNG = vec3(0.02);

// ---------- Gamma ----------

vec3 zuLinear(vec3 c) {
    return pow(c, vec3(GAMMA));
}

vec3 zuBildschirm(vec3 c) {
    return pow(c, vec3(1.0 / GAMMA));
}

// ---------- Teile der Beleuchtung ----------

// 4.3.4
float abschwaechung(vec3 k, float d) {
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// 4.3.3: innen 1, aussen 0, dazwischen linear
float scheinwerfer(vec3 l) {
    float cosTheta = dot(-l, kegel.achse);
    float cosInnen = cos(kegel.innen);
    float cosAussen = cos(kegel.aussen);
    return clamp((cosTheta - cosAussen) / (cosInnen - cosAussen), 0.0, 1.0);
}

// Teil C
vec3 diffusAnteil(Licht licht, float d, vec3 n, vec3 l) {
    float cosAlpha = max(dot(n, l), 0.0);
    return licht.farbe * abschwaechung(licht.abfall, d) * cosAlpha;
}

// Teil D, 4.7: mit Halbvektor
vec3 glanzAnteil(Licht licht, float d, vec3 n, vec3 l, vec3 v) {
    vec3 halb = normalize(l + v);
    float cosBeta = max(dot(n, halb), 0.0);
    return licht.farbe * abschwaechung(licht.abfall, d) * pow(cosBeta, haerte);
}

// Teil A
vec3 emission() {
    return zuLinear(texture(leuchtTex, uv).rgb) * toenung;
}

// ---------- Summe ----------

void main() {
    vec3 n = normalize(normale);
    vec3 v = normalize(blick);

    vec3 diffus = UMGEBUNG; // Teil B
    vec3 glanz = vec3(0.0);

    // Punktlicht am Motorrad
    vec3 lMotor = normalize(zuMotor);
    float dMotor = length(zuMotor);
    diffus += diffusAnteil(motor, dMotor, n, lMotor);
    glanz += glanzAnteil(motor, dMotor, n, lMotor, v);

    // Scheinwerfer
    vec3 lLampe = normalize(zuLampe);
    float dLampe = length(zuLampe);
    float kegelAnteil = scheinwerfer(lLampe);
    diffus += diffusAnteil(lampe, dLampe, n, lLampe) * kegelAnteil;
    glanz += glanzAnteil(lampe, dLampe, n, lLampe, v) * kegelAnteil;

    // Ecken
    for (int i = 0; i < ECKEN; i++) {
        vec3 lEcke = normalize(zuEcke[i]);
        float dEcke = length(zuEcke[i]);
        diffus += diffusAnteil(ecke[i], dEcke, n, lEcke);
        glanz += glanzAnteil(ecke[i], dEcke, n, lEcke, v);
    }

    vec3 farbTextur = zuLinear(texture(farbTex, uv).rgb);
    vec3 glanzTextur = texture(glanzTex, uv).rgb;

    vec3 summe = emission() + farbTextur * diffus + glanzTextur * glanz;
    bildpunkt = vec4(zuBildschirm(summe), 1.0);
}
