#version 330 core

// Daten vom Vertexshader
in struct VertexData
{
    vec3 position;
    vec2 texcoord;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight;
    vec3 toSpotLight;
} vertexData;

in vec3 toEckLight[4];

// Material
uniform sampler2D emit;
uniform sampler2D diff;
uniform sampler2D spec;
uniform float shininess;

// Farbe der Emission (4.4)
uniform vec3 farbe;

// Punktlicht am Motorrad
uniform vec3 pointLightCol;
uniform vec3 pointLightAttParam;

// Scheinwerfer
uniform vec3 spotLightCol;
uniform vec3 spotLightAttParam;
uniform vec3 spotLightDir;
uniform vec2 spotLightAngle;     // x = innen, y = aussen, schon in Radiant

// Punktlichter in den Ecken
uniform vec3 eckLightCol[4];
uniform vec3 eckLightAttParam[4];

out vec4 color;

// Phong: C + D
vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diffCol, vec3 specCol, float shine) {
    float cosA = max(0.0, dot(n, l));
    vec3 diffuse = diffCol * cosA;

    // altes Phong-Modell:
    //vec3 r = reflect(-l, n);
    //float cosB = max(0.0, dot(v, r));
    vec3 halfwayDir = normalize(v + l);
    float cosB = max(0.0, dot(n, halfwayDir));
    vec3 specular = specCol * pow(cosB, shine);

    return diffuse + specular;
}

float attenuate(float d, vec3 k) {
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

vec3 pointLightIntensity(vec3 lightCol, float d, vec3 k) {
    return lightCol * attenuate(d, k);
}

vec3 spotLightIntensity(vec3 lightCol, float d, vec3 k, vec3 sp, vec3 spDir) {
    float cosTheta = dot(-sp, normalize(spDir));
    float cosGamma = cos(spotLightAngle.y);
    float cosPhi = cos(spotLightAngle.x);

    float intensity = (cosTheta - cosGamma) / (cosPhi - cosGamma);
    intensity = clamp(intensity, 0.0, 1.0);
    return lightCol * intensity * attenuate(d, k);
}

void main() {
    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);

    // Entfernung steckt in der Laenge der Vektoren
    float lpLaenge = length(vertexData.toPointLight);
    float spLaenge = length(vertexData.toSpotLight);
    vec3 lp = normalize(vertexData.toPointLight);
    vec3 sp = normalize(vertexData.toSpotLight);

    vec3 emitCol = texture(emit, vertexData.texcoord).rgb;
    vec3 diffCol = texture(diff, vertexData.texcoord).rgb;
    vec3 specCol = texture(spec, vertexData.texcoord).rgb;

    // A: Emission
    vec3 result = emitCol * farbe;

    // B: Ambient
    result += diffCol * vec3(0.02);

    // C + D fuer alle Lichter
    result += shade(n, lp, v, diffCol, specCol, shininess) * pointLightIntensity(pointLightCol, lpLaenge, pointLightAttParam);
    result += shade(n, sp, v, diffCol, specCol, shininess) * spotLightIntensity(spotLightCol, spLaenge, spotLightAttParam, sp, spotLightDir);

    for (int i = 0; i < 4; i++) {
        float epLaenge = length(toEckLight[i]);
        vec3 ep = normalize(toEckLight[i]);
        result += shade(n, ep, v, diffCol, specCol, shininess) * pointLightIntensity(eckLightCol[i], epLaenge, eckLightAttParam[i]);
    }

    //color = vec4(n, 1.0);     // Test: Normalen anzeigen
    color = vec4(result, 1.0);
}
