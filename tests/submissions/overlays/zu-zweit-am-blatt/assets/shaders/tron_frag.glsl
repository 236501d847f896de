#version 330 core

// keep in sync with the vertex shader
#define LAMP_COUNT 6
// index of the only lamp that has a beam
#define HEADLIGHT 1

in vec2 uv;
in vec3 surfaceNormal;
in vec3 toEye;
in vec3 toLamp[LAMP_COUNT];

struct Lamp {
    vec3 power;     // color times intensity
    vec3 fade;      // constant, linear, quadratic
};

struct Beam {
    vec3 axis;      // view space, away from the lamp
    float full;     // cosine, everything inside is fully lit
    float none;     // cosine, nothing outside
};

uniform sampler2D albedoMap;
uniform sampler2D mirrorMap;
uniform sampler2D glowMap;
uniform float hardness;
uniform vec3 glowTint;

uniform Lamp lamps[LAMP_COUNT];
uniform Beam headBeam;

uniform float time; // was for the pulsing, Kotlin does that now

out vec4 fragment;

float fadeOut(vec3 k, float dist) {
    return 1.0 / dot(k, vec3(1.0, dist, dist * dist));
}

float insideBeam(vec3 L) {
    float c = dot(L, -normalize(headBeam.axis));
    return clamp((c - headBeam.none) / (headBeam.full - headBeam.none), 0.0, 1.0);
}

// x = diffuse weight, y = specular weight (Blinn-Phong)
vec2 weights(vec3 N, vec3 L, vec3 V) {
    vec3 H = normalize(L + V);
    float nl = max(dot(N, L), 0.0);
    float nh = max(dot(N, H), 0.0);
    return vec2(nl, pow(nh, hardness));
}

void main() {
    vec3 N = normalize(surfaceNormal);
    vec3 V = normalize(toEye);

    vec3 lit = vec3(0.0);
    vec3 shine = vec3(0.0);

    for (int i = 0; i < LAMP_COUNT; ++i) {
        float dist = length(toLamp[i]);
        vec3 L = toLamp[i] / dist;

        vec3 arriving = lamps[i].power * fadeOut(lamps[i].fade, dist);
        if (i == HEADLIGHT) arriving *= insideBeam(L);

        vec2 w = weights(N, L, V);
        lit += arriving * w.x;
        shine += arriving * w.y;
    }

    vec3 albedo = texture(albedoMap, uv).rgb;
    vec3 mirror = texture(mirrorMap, uv).rgb;
    vec3 glow = texture(glowMap, uv).rgb * glowTint;

    fragment = vec4(glow + albedo * lit + mirror * shine, 1.0);
}
