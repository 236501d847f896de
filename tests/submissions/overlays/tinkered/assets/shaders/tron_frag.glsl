#version 330 core

in vec2 tc;
in vec3 N;
in vec3 zurKamera;
in vec3 zumMotorradLicht;
in vec3 zumScheinwerfer;
in vec3 zuRot;
in vec3 zuBlau;
in vec3 zuGelb;
in vec3 zuTuerkis;

// Material
uniform sampler2D texturEmit;
uniform sampler2D texturDiff;
uniform sampler2D texturSpec;
uniform float glaenzend;
uniform vec3 leuchtFarbe;

// Lampen
uniform vec3 motorradLicht_farbe;
uniform vec3 motorradLicht_k;
uniform vec3 scheinwerfer_farbe;
uniform vec3 scheinwerfer_k;
uniform vec3 scheinwerfer_richtung;
uniform float scheinwerfer_innen;
uniform float scheinwerfer_aussen;
uniform vec3 rot_farbe;
uniform vec3 rot_k;
uniform vec3 blau_farbe;
uniform vec3 blau_k;
uniform vec3 gelb_farbe;
uniform vec3 gelb_k;
uniform vec3 tuerkis_farbe;
uniform vec3 tuerkis_k;

out vec4 color;

// Pythagoras
float wieWeit(vec3 v) {
    float quadrat = v.x * v.x + v.y * v.y + v.z * v.z;
    return sqrt(quadrat);
}

// Attenuation aus dem Aufgabenblatt
float schwaecher(vec3 zumLicht, vec3 k) {
    float d = wieWeit(zumLicht);
    float konstant = k.x;
    float linear = k.y * d;
    float quadratisch = k.z * d * d;
    float unten = konstant + linear + quadratisch;
    return 1.0 / unten;
}

// cos vom Winkel zwischen a und b, nie kleiner als 0
float cosOderNull(vec3 a, vec3 b) {
    vec3 a1 = normalize(a);
    vec3 b1 = normalize(b);
    float c = dot(a1, b1);
    return max(c, 0.0);
}

// 0 bis 1: wie stark der Scheinwerfer hier ist
float imKegel(vec3 zumLicht) {
    vec3 vomLicht = normalize(zumLicht) * -1.0;
    vec3 richtung = normalize(scheinwerfer_richtung);
    float cosTheta = dot(vomLicht, richtung);
    float cosInnen = cos(scheinwerfer_innen);
    float cosAussen = cos(scheinwerfer_aussen);
    float oben = cosTheta - cosAussen;
    float unten = cosInnen - cosAussen;
    float intensitaet = oben / unten;
    intensitaet = clamp(intensitaet, 0.0, 1.0);
    return intensitaet;
}

// eine Lampe mit Blinn Phong
vec3 lampe(vec3 zumLicht, vec3 normale, vec3 kamera, vec3 diffus, vec3 spec, vec3 farbe, vec3 k) {
    vec3 licht = normalize(zumLicht);

    // C
    float cosAlpha = cosOderNull(normale, licht);
    vec3 termC = diffus * cosAlpha;

    // D
    vec3 halb = licht + kamera;
    halb = normalize(halb);
    float cosBeta = cosOderNull(normale, halb);
    float hoch = pow(cosBeta, glaenzend);
    vec3 termD = spec * hoch;
    if (cosAlpha <= 0.0) {
        // von hinten kein Glanz
        termD = vec3(0.0);
    }

    vec3 termCD = termC + termD;
    float weniger = schwaecher(zumLicht, k);
    vec3 farbeHier = farbe * weniger;
    return termCD * farbeHier;
}

void main() {
    // Texturen
    vec3 emit = texture(texturEmit, tc).rgb;
    vec3 diffus = texture(texturDiff, tc).rgb;
    vec3 spec = texture(texturSpec, tc).rgb;

    vec3 normale = normalize(N);
    vec3 kamera = normalize(zurKamera);

    // A und B
    vec3 termA = emit * leuchtFarbe;
    vec3 umgebung = vec3(0.02, 0.02, 0.02);
    vec3 termB = diffus * umgebung;

    // C und D fuer alle
    vec3 vomMotorradLicht = lampe(zumMotorradLicht, normale, kamera, diffus, spec, motorradLicht_farbe, motorradLicht_k);

    vec3 vomScheinwerfer = lampe(zumScheinwerfer, normale, kamera, diffus, spec, scheinwerfer_farbe, scheinwerfer_k);
    float kegel = imKegel(zumScheinwerfer);
    vomScheinwerfer = vomScheinwerfer * kegel;

    vec3 vonRot = lampe(zuRot, normale, kamera, diffus, spec, rot_farbe, rot_k);
    vec3 vonBlau = lampe(zuBlau, normale, kamera, diffus, spec, blau_farbe, blau_k);
    vec3 vonGelb = lampe(zuGelb, normale, kamera, diffus, spec, gelb_farbe, gelb_k);
    vec3 vonTuerkis = lampe(zuTuerkis, normale, kamera, diffus, spec, tuerkis_farbe, tuerkis_k);

    vec3 ergebnis = termA + termB;
    ergebnis = ergebnis + vomMotorradLicht;
    ergebnis = ergebnis + vomScheinwerfer;
    ergebnis = ergebnis + vonRot + vonBlau + vonGelb + vonTuerkis;

    color = vec4(ergebnis, 1.0);
}
