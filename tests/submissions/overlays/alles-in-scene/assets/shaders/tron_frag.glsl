#version 330 core

in vec2 vTex;
in vec3 vNormal;
in vec3 toCamera;
in vec3 toLight1;
in vec3 toLight2;
in vec3 toLight3;
in vec3 toLight4;
in vec3 toLight5;
in vec3 toLight6;

uniform sampler2D texEmit;
uniform sampler2D texDiff;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 farbe;

uniform vec3 light1_farbe;
uniform vec3 light2_farbe;
uniform vec3 light3_farbe;
uniform vec3 light4_farbe;
uniform vec3 light5_farbe;
uniform vec3 light6_farbe;
uniform vec3 light1_att;
uniform vec3 light2_att;
uniform vec3 light3_att;
uniform vec3 light4_att;
uniform vec3 light5_att;
uniform vec3 light6_att;
uniform vec3 spot_dir;
uniform float spot_innen;
uniform float spot_aussen;

out vec4 color;

void main() {
    vec3 N = normalize(vNormal);
    vec3 V = normalize(toCamera);
    vec3 emi = texture(texEmit, vTex).rgb;
    vec3 dif = texture(texDiff, vTex).rgb;
    vec3 spe = texture(texSpec, vTex).rgb;

    // emissive
    vec3 result = emi * farbe;

    // Licht 1: Punktlicht am Motorrad
    float d1 = length(toLight1);
    vec3 L1 = normalize(toLight1);
    float cosa1 = max(dot(N, L1), 0.0);
    vec3 H1 = normalize(V + L1);
    float cosb1 = max(dot(N, H1), 0.0);
    float att1 = 1.0 / (light1_att.x + light1_att.y * d1 + light1_att.z * d1 * d1);
    vec3 diffuse1 = dif * cosa1 * light1_farbe * att1;
    vec3 specular1 = spe * pow(cosb1, shininess) * light1_farbe * att1;
    result += diffuse1 + specular1;

    // Licht 2: Scheinwerfer
    float d2 = length(toLight2);
    vec3 L2 = normalize(toLight2);
    float cosa2 = max(dot(N, L2), 0.0);
    vec3 H2 = normalize(V + L2);
    float cosb2 = max(dot(N, H2), 0.0);
    float att2 = 1.0 / (light2_att.x + light2_att.y * d2 + light2_att.z * d2 * d2);
    float theta = dot(normalize(-toLight2), normalize(spot_dir));
    float gamma = cos(spot_innen);
    float phi = cos(spot_aussen);
    float intensity = clamp((theta - phi) / (gamma - phi), 0.0, 1.0);
    vec3 diffuse2 = dif * cosa2 * light2_farbe * att2 * intensity;
    vec3 specular2 = spe * pow(cosb2, shininess) * light2_farbe * att2 * intensity;
    result += diffuse2 + specular2;

    // Licht 3: Ecke rot
    float d3 = length(toLight3);
    vec3 L3 = normalize(toLight3);
    float cosa3 = max(dot(N, L3), 0.0);
    vec3 H3 = normalize(V + L3);
    float cosb3 = max(dot(N, H3), 0.0);
    float att3 = 1.0 / (light3_att.x + light3_att.y * d3 + light3_att.z * d3 * d3);
    vec3 diffuse3 = dif * cosa3 * light3_farbe * att3;
    vec3 specular3 = spe * pow(cosb3, shininess) * light3_farbe * att3;
    result += diffuse3 + specular3;

    // Licht 4: Ecke blau
    float d4 = length(toLight4);
    vec3 L4 = normalize(toLight4);
    float cosa4 = max(dot(N, L4), 0.0);
    vec3 H4 = normalize(V + L4);
    float cosb4 = max(dot(N, H4), 0.0);
    float att4 = 1.0 / (light4_att.x + light4_att.y * d4 + light4_att.z * d4 * d4);
    vec3 diffuse4 = dif * cosa4 * light4_farbe * att4;
    vec3 specular4 = spe * pow(cosb4, shininess) * light4_farbe * att4;
    result += diffuse4 + specular4;

    // Licht 5: Ecke gelb
    float d5 = length(toLight5);
    vec3 L5 = normalize(toLight5);
    float cosa5 = max(dot(N, L5), 0.0);
    vec3 H5 = normalize(V + L5);
    float cosb5 = max(dot(N, H5), 0.0);
    float att5 = 1.0 / (light5_att.x + light5_att.y * d5 + light5_att.z * d5 * d5);
    vec3 diffuse5 = dif * cosa5 * light5_farbe * att5;
    vec3 specular5 = spe * pow(cosb5, shininess) * light5_farbe * att5;
    result += diffuse5 + specular5;

    // Licht 6: Ecke lila
    float d6 = length(toLight6);
    vec3 L6 = normalize(toLight6);
    float cosa6 = max(dot(N, L6), 0.0);
    vec3 H6 = normalize(V + L6);
    float cosb6 = max(dot(N, H6), 0.0);
    float att6 = 1.0 / (light6_att.x + light6_att.y * d6 + light6_att.z * d6 * d6);
    vec3 diffuse6 = dif * cosa6 * light6_farbe * att6;
    vec3 specular6 = spe * pow(cosb6, shininess) * light6_farbe * att6;
    result += diffuse6 + specular6;

    color = vec4(result, 1.0);
}
