#version 330 core

in vec2 uv;
in vec3 nrm;
in vec3 toCam;
in vec3 toLight;
in vec3 toSpot;
in vec3 spotAxis;
in vec3 toRed;
in vec3 toGreen;
in vec3 toBlue;
in vec3 toYellow;

uniform sampler2D emitTex;
uniform sampler2D diffTex;
uniform sampler2D specTex;
uniform float shine;
uniform vec3 tint;

uniform vec3 lightCol;
uniform vec3 lightK;
uniform vec3 spotCol;
uniform vec3 spotK;
uniform vec2 spotCone;
uniform vec3 redCol;
uniform vec3 redK;
uniform vec3 greenCol;
uniform vec3 greenK;
uniform vec3 blueCol;
uniform vec3 blueK;
uniform vec3 yellowCol;
uniform vec3 yellowK;

out vec4 col;

void main() {
    vec3 md = texture(diffTex, uv).rgb;
    vec3 ms = texture(specTex, uv).rgb;
    vec3 n = normalize(nrm);
    vec3 e = normalize(toCam);

    // emission
    vec3 sum = texture(emitTex, uv).rgb * tint;

    // motorcycle
    vec3 l1 = normalize(toLight);
    float d1 = length(toLight);
    float att1 = 1.0 / (lightK.x + lightK.y * d1 + lightK.z * d1 * d1);
    float diff1 = max(dot(n, l1), 0.0);
    float spec1 = pow(max(dot(n, normalize(l1 + e)), 0.0), shine);
    if (diff1 == 0.0) spec1 = 0.0;
    sum += (md * diff1 + ms * spec1) * lightCol * att1;

    // spot
    vec3 l2 = normalize(toSpot);
    float d2 = length(toSpot);
    float att2 = 1.0 / (spotK.x + spotK.y * d2 + spotK.z * d2 * d2);
    float diff2 = max(dot(n, l2), 0.0);
    float spec2 = pow(max(dot(n, normalize(l2 + e)), 0.0), shine);
    if (diff2 == 0.0) spec2 = 0.0;
    float theta = dot(-l2, normalize(spotAxis));
    float cone = clamp((theta - spotCone.y) / (spotCone.x - spotCone.y), 0.0, 1.0);
    sum += (md * diff2 + ms * spec2) * spotCol * att2 * cone;

    // red
    vec3 l3 = normalize(toRed);
    float d3 = length(toRed);
    float att3 = 1.0 / (redK.x + redK.y * d3 + redK.z * d3 * d3);
    float diff3 = max(dot(n, l3), 0.0);
    float spec3 = pow(max(dot(n, normalize(l3 + e)), 0.0), shine);
    if (diff3 == 0.0) spec3 = 0.0;
    sum += (md * diff3 + ms * spec3) * redCol * att3;

    // green
    vec3 l4 = normalize(toGreen);
    float d4 = length(toGreen);
    float att4 = 1.0 / (greenK.x + greenK.y * d4 + greenK.z * d4 * d4);
    float diff4 = max(dot(n, l4), 0.0);
    float spec4 = pow(max(dot(n, normalize(l4 + e)), 0.0), shine);
    if (diff4 == 0.0) spec4 = 0.0;
    sum += (md * diff4 + ms * spec4) * greenCol * att4;

    // blue
    vec3 l5 = normalize(toBlue);
    float d5 = length(toBlue);
    float att5 = 1.0 / (blueK.x + blueK.y * d5 + blueK.z * d5 * d5);
    float diff5 = max(dot(n, l5), 0.0);
    float spec5 = pow(max(dot(n, normalize(l5 + e)), 0.0), shine);
    if (diff5 == 0.0) spec5 = 0.0;
    sum += (md * diff5 + ms * spec5) * blueCol * att5;

    // yellow
    vec3 l6 = normalize(toYellow);
    float d6 = length(toYellow);
    float att6 = 1.0 / (yellowK.x + yellowK.y * d6 + yellowK.z * d6 * d6);
    float diff6 = max(dot(n, l6), 0.0);
    float spec6 = pow(max(dot(n, normalize(l6 + e)), 0.0), shine);
    if (diff6 == 0.0) spec6 = 0.0;
    sum += (md * diff6 + ms * spec6) * yellowCol * att6;

    col = vec4(sum, 1.0);
}
