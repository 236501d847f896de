#version 330 core
in vec2 tc;
in vec3 norm;
in vec3 toCamera;
in vec3 toLight1;
in vec3 toLight2;
in vec3 toLight3;
in vec3 toLight4;
in vec3 toLight5;

uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D spec;
uniform float shininess;
uniform vec3 farbe;

uniform vec3 light1_col;
uniform vec3 light1_att;
uniform vec3 light2_col;
uniform vec3 light2_att;
uniform vec3 light2_dir;
uniform float light2_gamma;
uniform float light2_phi;
uniform vec3 light3_col;
uniform vec3 light3_att;
uniform vec3 light4_col;
uniform vec3 light4_att;
uniform vec3 light5_col;
uniform vec3 light5_att;

out vec4 color;

void main() {
    vec3 N = normalize(norm);
    vec3 V = normalize(toCamera);

    vec3 texDiff = texture(diff, tc).rgb;
    vec3 texEmit = texture(emit, tc).rgb;
    vec3 texSpec = texture(spec, tc).rgb;

    // Emission
    vec3 ergebnis = texEmit * farbe;

    // Ambient
    ergebnis += texDiff * vec3(0.02, 0.02, 0.02);

    // ---------- Licht 1 (Motorrad) ----------
    float d1 = length(toLight1);
    vec3 L1 = normalize(toLight1);
    float cosa1 = max(dot(N, L1), 0.0);
    vec3 H1 = normalize(V + L1);
    float cosb1 = max(dot(N, H1), 0.0);
    //vec3 R1 = reflect(-L1, N);
    //float cosb1 = max(dot(R1, V), 0.0);
    float att1 = 1.0 / (light1_att.x + light1_att.y * d1 + light1_att.z * d1 * d1);
    vec3 diff1 = texDiff * cosa1;
    vec3 spec1 = texSpec * pow(cosb1, shininess);
    ergebnis += (diff1 + spec1) * light1_col * att1;

    // ---------- Licht 2 (Spot) ----------
    float d2 = length(toLight2);
    vec3 L2 = normalize(toLight2);
    float cosa2 = max(dot(N, L2), 0.0);
    vec3 H2 = normalize(V + L2);
    float cosb2 = max(dot(N, H2), 0.0);
    //vec3 R2 = reflect(-L2, N);
    //float cosb2 = max(dot(R2, V), 0.0);
    float att2 = 1.0 / (light2_att.x + light2_att.y * d2 + light2_att.z * d2 * d2);
    float theta = dot(normalize(light2_dir), -L2);
    //float theta = acos(dot(normalize(light2_dir), -L2));
    float I = (theta - cos(light2_phi)) / (cos(light2_gamma) - cos(light2_phi));
    I = clamp(I, 0.0, 1.0);
    vec3 diff2 = texDiff * cosa2;
    vec3 spec2 = texSpec * pow(cosb2, shininess);
    ergebnis += (diff2 + spec2) * light2_col * att2 * I;

    // ---------- Licht 3 ----------
    float d3 = length(toLight3);
    vec3 L3 = normalize(toLight3);
    float cosa3 = max(dot(N, L3), 0.0);
    vec3 H3 = normalize(V + L3);
    float cosb3 = max(dot(N, H3), 0.0);
    float att3 = 1.0 / (light3_att.x + light3_att.y * d3 + light3_att.z * d3 * d3);
    vec3 diff3 = texDiff * cosa3;
    vec3 spec3 = texSpec * pow(cosb3, shininess);
    ergebnis += (diff3 + spec3) * light3_col * att3;

    // ---------- Licht 4 ----------
    float d4 = length(toLight4);
    vec3 L4 = normalize(toLight4);
    float cosa4 = max(dot(N, L4), 0.0);
    vec3 H4 = normalize(V + L4);
    float cosb4 = max(dot(N, H4), 0.0);
    float att4 = 1.0 / (light4_att.x + light4_att.y * d4 + light4_att.z * d4 * d4);
    vec3 diff4 = texDiff * cosa4;
    vec3 spec4 = texSpec * pow(cosb4, shininess);
    ergebnis += (diff4 + spec4) * light4_col * att4;

    // ---------- Licht 5 ----------
    float d5 = length(toLight5);
    vec3 L5 = normalize(toLight5);
    float cosa5 = max(dot(N, L5), 0.0);
    vec3 H5 = normalize(V + L5);
    float cosb5 = max(dot(N, H5), 0.0);
    float att5 = 1.0 / (light5_att.x + light5_att.y * d5 + light5_att.z * d5 * d5);
    vec3 diff5 = texDiff * cosa5;
    vec3 spec5 = texSpec * pow(cosb5, shininess);
    ergebnis += (diff5 + spec5) * light5_col * att5;

    //color = vec4(N, 1.0);
    //color = vec4(abs(normalize(norm)), 1.0);
    //color = vec4(tc, 0.0, 1.0);
    color = vec4(ergebnis, 1.0);
}
