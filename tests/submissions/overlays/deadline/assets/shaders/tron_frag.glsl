#version 330 core

in vec2 tc;
in vec3 normal;
in vec3 toCamera;
in vec3 toLight1;
in vec3 toLight2;
in vec3 toLight3;
in vec3 toLight4;
in vec3 toLight5;
in vec3 toLight6;

uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D specular;
uniform float shininess;
uniform vec3 farbe;

uniform vec3 lightColor;
uniform vec3 att;
uniform vec3 spot_lightColor;
uniform vec3 spot_att;
uniform vec3 spotDir;
uniform float innen;
uniform float aussen;
uniform vec3 ecke1_lightColor;
uniform vec3 ecke1_att;
uniform vec3 ecke2_lightColor;
uniform vec3 ecke2_att;
uniform vec3 ecke3_lightColor;
uniform vec3 ecke3_att;
uniform vec3 ecke4_lightColor;
uniform vec3 ecke4_att;

out vec4 color;

void main() {
    vec3 N = normalize(normal);
    vec3 V = normalize(toCamera);
    vec3 ergebnis = texture(emit, tc).rgb * farbe;

    // Licht 1: Punktlicht Motorrad
    vec3 L1 = toLight1;
    float d1 = length(L1);
    L1 = normalize(L1);
    float cosA1 = max(dot(N, L1), 0.0f);
    vec3 H1 = normalize(L1 + V);
    float cosB1 = max(dot(N, H1), 0.0f);
    float att1 = 1.0f / (att.x + att.y * d1 + att.z * d1 * d1);
    vec3 diff1 = texture(diff, tc).rgb * cosA1;
    vec3 spec1 = texture(specular, tc).rgb * pow(cosB1, shininess);
    ergebnis += (diff1 + spec1) * lightColor * att1;

    // Licht 2: Spot
    vec3 L2 = toLight2;
    float d2 = length(L2);
    L2 = normalize(L2);
    float cosA2 = max(dot(N, L2), 0.0f);
    vec3 H2 = normalize(L2 + V);
    float cosB2 = max(dot(N, H2), 0.0f);
    float cosTheta = dot(-L2, normalize(spotDir));
    float I = clamp((cosTheta - cos(aussen)) / (cos(innen) - cos(aussen)), 0.0f, 1.0f);
    float att2 = 1.0f / (spot_att.x + spot_att.y * d2 + spot_att.z * d2 * d2);
    vec3 diff2 = texture(diff, tc).rgb * cosA2;
    vec3 spec2 = texture(specular, tc).rgb * pow(cosB2, shininess);
    ergebnis += (diff2 + spec2) * spot_lightColor * att2 * I;

    // Licht 3
    vec3 L3 = toLight3;
    float d3 = length(L3);
    L3 = normalize(L3);
    float cosA3 = max(dot(N, L3), 0.0f);
    vec3 H3 = normalize(L3 + normalize(toCamera));
    float cosB3 = max(dot(N, H3), 0.0f);
    float att3 = 1.0f / (ecke1_att.x + ecke1_att.y * d3 + ecke1_att.z * d3 * d3);
    vec3 diff3 = texture(diff, tc).rgb * cosA3;
    vec3 spec3 = texture(specular, tc).rgb * pow(cosB3, shininess);
    ergebnis += (diff3 + spec3) * ecke1_lightColor * att3;

    // Licht 4
    vec3 L4 = toLight4;
    float d4 = length(L4);
    L4 = normalize(L4);
    float cosA4 = max(dot(N, L4), 0.0f);
    vec3 H4 = normalize(L4 + normalize(toCamera));
    float cosB4 = max(dot(N, H4), 0.0f);
    float att4 = 1.0f / (ecke2_att.x + ecke2_att.y * d4 + ecke2_att.z * d4 * d4);
    vec3 diff4 = texture(diff, tc).rgb * cosA4;
    vec3 spec4 = texture(specular, tc).rgb * pow(cosB4, shininess);
    ergebnis += (diff4 + spec4) * ecke2_lightColor * att4;

    // Licht 5
    vec3 L5 = toLight5;
    float d5 = length(L5);
    L5 = normalize(L5);
    float cosA5 = max(dot(N, L5), 0.0f);
    vec3 H5 = normalize(L5 + normalize(toCamera));
    float cosB5 = max(dot(N, H5), 0.0f);
    float att5 = 1.0f / (ecke3_att.x + ecke3_att.y * d5 + ecke3_att.z * d5 * d5);
    vec3 diff5 = texture(diff, tc).rgb * cosA5;
    vec3 spec5 = texture(specular, tc).rgb * pow(cosB5, shininess);
    ergebnis += (diff5 + spec5) * ecke3_lightColor * att5;

    // Licht 6
    vec3 L6 = toLight6;
    float d6 = length(L6);
    L6 = normalize(L6);
    float cosA6 = max(dot(N, L6), 0.0f);
    vec3 H6 = normalize(L6 + normalize(toCamera));
    float cosB6 = max(dot(N, H6), 0.0f);
    float att6 = 1.0f / (ecke4_att.x + ecke4_att.y * d6 + ecke4_att.z * d6 * d6);
    vec3 diff6 = texture(diff, tc).rgb * cosA6;
    vec3 spec6 = texture(specular, tc).rgb * pow(cosB6, shininess);
    ergebnis += (diff6 + spec6) * ecke4_lightColor * att6;

    color = vec4(ergebnis, 1.0f);
}
