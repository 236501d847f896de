#version 330 core
// One factor of the lighting model as a colour, for one light; behind the same vertex shader and with the uniforms of scene.frag.

#include "../light.glsl"
#include "../surface.glsl"
#include "../lighting.glsl"

uniform int factor;  // which one: the numbers below
uniform int chosen;  // of which light

const int NORMAL = 0;
const int TO_CAMERA = 1;
const int TO_LIGHT = 2;
const int HALF_VECTOR = 3;
const int REFLECTED = 4;
const int COS_ALPHA = 5;
const int COS_BETA = 6;
const int HIGHLIGHT = 7;
const int ATTENUATION = 8;
const int CONE = 9;

out vec4 fragColor;

// A direction: -1..1 along x, y and z is 0..1 of red, green and blue. No direction is black.
vec3 direction(vec3 v) {
    return v == vec3(0.0) ? v : 0.5 + 0.5 * v;
}

// A number: 0..1 from black to white, negative in blue, more than 1 (up to 2) from white to orange.
vec3 number(float x) {
    if (x < 0.0) return vec3(0.0, 0.0, min(-x, 1.0));
    float above = clamp(x - 1.0, 0.0, 1.0);
    return min(x, 1.0) * (1.0 - above * vec3(0.0, 0.5, 1.0));
}

void main() {
    vec3 l = vec3(0.0);
    float f = 0.0;
    float intensity = 1.0;
    for (int i = 0; i < LIGHTS; i++) {
        if (i != chosen) continue;
        l = normalizeOrZero(toLightView[i]);
        f = attenuationFactor(toLightView[i], light[i].attenuation);
        intensity = coneIntensity(-l, light[i].direction, light[i].cone);
    }
    vec3 n = normalizeOrZero(inRange(normalView));
    vec3 v = normalizeOrZero(toCameraView);

    vec3 color = vec3(0.0);
    if (factor == NORMAL) color = direction(n);
    else if (factor == TO_CAMERA) color = direction(v);
    else if (factor == TO_LIGHT) color = direction(l);
    else if (factor == HALF_VECTOR) color = direction(halfVector(l, v));
    else if (factor == REFLECTED) color = direction(reflectedVector(n, l));
    else if (factor == COS_ALPHA) color = number(dot(n, l));
    else if (factor == COS_BETA) color = number(specularCosine(n, l, v));
    else if (factor == HIGHLIGHT) color = number(specularFactor(n, l, v));
    else if (factor == ATTENUATION) color = number(f);
    else if (factor == CONE) color = number(intensity);
    fragColor = vec4(color, 1.0);
}
