#version 330 core

in vec2 tc;
in vec3 normaleView;
in vec3 toCamera;
in vec3 toMotorradLicht;
in vec3 toScheinwerfer;
in vec3 toEcke1;
in vec3 toEcke2;
in vec3 toEcke3;
in vec3 toEcke4;

// Material
uniform sampler2D texDiff;
uniform sampler2D texEmit;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 farbe;

// Punktlicht am Motorrad
uniform vec3 motorradLichtFarbe;
uniform vec3 motorradLichtDaempfung;

// Scheinwerfer
uniform vec3 scheinwerferFarbe;
uniform vec3 scheinwerferDaempfung;
uniform vec3 scheinwerferRichtung;
uniform vec2 scheinwerferWinkel;

// Ecken
uniform vec3 ecke1Farbe;
uniform vec3 ecke1Daempfung;
uniform vec3 ecke2Farbe;
uniform vec3 ecke2Daempfung;
uniform vec3 ecke3Farbe;
uniform vec3 ecke3Daempfung;
uniform vec3 ecke4Farbe;
uniform vec3 ecke4Daempfung;

out vec4 color;

const vec3 umgebungslicht = vec3(0.03);

// 4.3.4
float abschwaechung(vec3 toLight, vec3 k) {
    float d = length(toLight);
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// 4.3.3
float kegel(vec3 toLight, vec3 richtung, vec2 winkel) {
    float cosTheta = dot(normalize(-toLight), normalize(richtung));
    float cosInnen = cos(winkel.x);
    float cosAussen = cos(winkel.y);
    return clamp((cosTheta - cosAussen) / (cosInnen - cosAussen), 0.0, 1.0);
}

vec3 phong(vec3 n, vec3 toLight, vec3 v, vec3 diffus, vec3 glanz) {
    vec3 l = normalize(toLight);
    float cosa = max(0.0, dot(n, l));
    // alt: Phong mit reflektiertem Vektor
    // vec3 r = reflect(-l, n);
    // float cosb = max(0.0, dot(r, v));
    vec3 h = normalize(l + v);
    float cosb = max(0.0, dot(n, h));
    return diffus * cosa + glanz * pow(cosb, shininess);
}

void main() {
    vec3 n = normalize(normaleView);
    vec3 v = normalize(toCamera);

    vec3 emission = texture(texEmit, tc).rgb;
    vec3 diffus = texture(texDiff, tc).rgb;
    vec3 glanz = texture(texSpec, tc).rgb;

    vec3 ergebnis = emission * farbe;
    ergebnis += diffus * umgebungslicht;

    ergebnis += phong(n, toMotorradLicht, v, diffus, glanz) * motorradLichtFarbe * abschwaechung(toMotorradLicht, motorradLichtDaempfung);
    ergebnis += phong(n, toScheinwerfer, v, diffus, glanz) * scheinwerferFarbe * kegel(toScheinwerfer, scheinwerferRichtung, scheinwerferWinkel) * abschwaechung(toScheinwerfer, scheinwerferDaempfung);

    ergebnis += phong(n, toEcke1, v, diffus, glanz) * ecke1Farbe * abschwaechung(toEcke1, ecke1Daempfung);
    ergebnis += phong(n, toEcke2, v, diffus, glanz) * ecke2Farbe * abschwaechung(toEcke2, ecke2Daempfung);
    ergebnis += phong(n, toEcke3, v, diffus, glanz) * ecke3Farbe * abschwaechung(toEcke3, ecke3Daempfung);
    ergebnis += phong(n, toEcke4, v, diffus, glanz) * ecke4Farbe * abschwaechung(toEcke4, ecke4Daempfung);

    color = vec4(ergebnis, 1.0);
    // color = vec4(n, 1.0);
}
