#version 330 core

#define ANZAHL 5

in vec2 texKoord;
in vec3 normale;
in vec3 toCamera;
in vec3 toLight[ANZAHL];
in vec3 toStrahler;

uniform sampler2D emissiv;
uniform sampler2D diffus;
uniform sampler2D spekular;
uniform float shininess;
uniform vec3 farbe;
uniform vec3 ambient;

uniform vec3 lichtFarbe[ANZAHL];
uniform vec3 lichtAtt[ANZAHL];

uniform vec3 strahlerFarbe;
uniform vec3 strahlerAtt;
uniform vec3 strahlerRichtung;
// x: innerer Winkel, y: aeusserer Winkel (Radiant)
uniform vec2 strahlerKegel;

out vec4 fragFarbe;

vec3 diffuserAnteil(vec3 N, vec3 L) {
    float cosa = max(0.0, dot(N, L));
    return texture(diffus, texKoord).rgb * cosa;
}

vec3 spekularerAnteil(vec3 N, vec3 L, vec3 V) {
    vec3 H = normalize(V + L);
    float cosb = max(0.0, dot(N, H));
    return texture(spekular, texKoord).rgb * pow(cosb, shininess);
}

float daempfung(float d, vec3 att) {
    return 1.0 / (att.x + att.y * d + att.z * pow(d, 2.0));
}

float kegel(vec3 L, vec3 richtung) {
    float theta = dot(-L, normalize(richtung));
    float gamma = cos(strahlerKegel.x);
    float phi = cos(strahlerKegel.y);
    float I = (theta - phi) / (gamma - phi);
    return clamp(I, 0.0, 1.0);
}

void main() {
    vec3 N = normalize(normale);
    vec3 V = normalize(toCamera);

    vec3 ergebnis = texture(emissiv, texKoord).rgb * farbe;
    ergebnis += ambient * texture(diffus, texKoord).rgb;

    // Punktlichter
    for (int i = 0; i < ANZAHL; ++i) {
        vec3 L = normalize(toLight[i]);
        vec3 licht = lichtFarbe[i] * daempfung(length(toLight[i]), lichtAtt[i]);
        ergebnis += diffuserAnteil(N, L) * licht;
        ergebnis += spekularerAnteil(N, L, V) * licht;
    }

    // Scheinwerfer
    vec3 S = normalize(toStrahler);
    vec3 strahler = strahlerFarbe * kegel(S, strahlerRichtung) * daempfung(length(toStrahler), strahlerAtt);
    ergebnis += diffuserAnteil(N, S) * strahler;
    ergebnis += spekularerAnteil(N, S, V) * strahler;

    fragFarbe = vec4(ergebnis, 1.0);
}
