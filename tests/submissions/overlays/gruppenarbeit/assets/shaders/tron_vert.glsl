#version 330 core

// Blatt 4 - Vertexshader
// Ansicht = View Space. Hier wird alles in die Ansicht gebracht, normalisiert wird erst im Fragmentshader!

#define ECKEN 4

layout(location = 0) in vec3 ort;
layout(location = 1) in vec2 textur;
layout(location = 2) in vec3 senkrechte;

// Matrizen
uniform mat4 modell;
uniform mat4 ansicht;
uniform mat4 projektion;

// Material
uniform vec2 kachelung;

// Lichter, Positionen in Weltkoordinaten
uniform vec3 motorPos;
uniform vec3 lampePos;
uniform vec3 eckPos[ECKEN];

out vec2 uv;
out vec3 normale;
out vec3 blick;
out vec3 zuMotor;
out vec3 zuLampe;
out vec3 zuEcke[ECKEN];

vec3 punktInAnsicht() {
    return (ansicht * modell * vec4(ort, 1.0)).xyz;
}

vec3 normaleInAnsicht() {
    mat3 normalMat = transpose(inverse(mat3(ansicht * modell)));
    return normalMat * senkrechte;
}

// Vektor vom Punkt zum Licht
vec3 zumLicht(vec3 lichtPos, vec3 punkt) {
    vec3 lichtInAnsicht = (ansicht * vec4(lichtPos, 1.0)).xyz;
    return lichtInAnsicht - punkt;
}

void main() {
    vec3 punkt = punktInAnsicht();

    uv = textur * kachelung;
    normale = normaleInAnsicht();
    blick = -punkt; // die Kamera steht in der Ansicht im Ursprung

    zuMotor = zumLicht(motorPos, punkt);
    zuLampe = zumLicht(lampePos, punkt);
    for (int i = 0; i < ECKEN; i++) {
        zuEcke[i] = zumLicht(eckPos[i], punkt);
    }

    gl_Position = projektion * vec4(punkt, 1.0);
}
