#version 330 core
// One factor of the lighting model as a colour, for one light; behind the same vertex shader and with the uniforms of scene.frag.

const int LIGHTS = 10;

struct Light {
    vec3 position;
    vec3 color;
    vec3 attenuation;
    vec3 direction;
    vec2 cone;
};

struct Material {
    sampler2D emissive;
    sampler2D diffuse;
    sampler2D specular;
    float shininess;
};

in vec2 surfaceTexCoord;
in vec3 normalView;
in vec3 toCameraView;
in vec3 toLightView[max(LIGHTS, 1)];

uniform Material material;
uniform vec3 emissiveTint;
uniform vec3 ambient;
uniform bool blinnPhong;
uniform float inverseGamma;
uniform Light light[max(LIGHTS, 1)];

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

vec3 unit(vec3 v) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : vec3(0.0);
}

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

float attenuationFactor(float d, vec3 k) {
    return d > 0.0 ? 1.0 / (k.x + k.y * d + k.z * d * d) : 0.0;
}

float coneIntensity(vec3 fromLight, vec3 axis, vec2 cone) {
    vec3 chord = fromLight - axis;
    float versine = 0.5 * dot(chord, chord);
    float width = cone.y - cone.x;
    if (width > 0.0) return clamp((cone.y - versine) / width, 0.0, 1.0);
    return versine <= cone.y ? 1.0 : 0.0;
}

void main() {
    vec3 toLight = vec3(0.0);
    vec3 k = vec3(1.0, 0.0, 0.0);
    float intensity = 1.0;
    for (int i = 0; i < LIGHTS; i++) {
        if (i != chosen) continue;
        toLight = toLightView[i];
        k = light[i].attenuation;
        intensity = coneIntensity(-unit(toLight), light[i].direction, light[i].cone);
    }
    vec3 n = unit(normalView);
    vec3 v = unit(toCameraView);
    vec3 l = unit(toLight);
    vec3 h = unit(l + v);
    vec3 r = n == vec3(0.0) ? n : reflect(-l, n);
    float cosBeta = blinnPhong ? dot(n, h) : dot(r, v);

    vec3 color = vec3(0.0);
    if (factor == NORMAL) color = direction(n);
    else if (factor == TO_CAMERA) color = direction(v);
    else if (factor == TO_LIGHT) color = direction(l);
    else if (factor == HALF_VECTOR) color = direction(h);
    else if (factor == REFLECTED) color = direction(r);
    else if (factor == COS_ALPHA) color = number(dot(n, l));
    else if (factor == COS_BETA) color = number(cosBeta);
    else if (factor == HIGHLIGHT) color = number(cosBeta > 0.0 ? pow(cosBeta, material.shininess) : 0.0);
    else if (factor == ATTENUATION) color = number(attenuationFactor(length(toLight), k));
    else if (factor == CONE) color = number(intensity);
    fragColor = vec4(color, 1.0);
}
