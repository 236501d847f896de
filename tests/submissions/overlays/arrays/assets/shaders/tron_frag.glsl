#version 330 core

const int POINTS = 5;

in vec2 tc;
in vec3 normalView;
in vec3 toCamera;
in vec3 toPoints[POINTS];
in vec3 toSpot;

// material
uniform sampler2D texEmit;
uniform sampler2D texDiff;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 tint;

// lights, with their positions in world space
struct Light {
    vec3 pos;
    vec3 color;
    vec3 att;
};

struct Spot {
    vec3 pos;
    vec3 color;
    vec3 att;
    vec3 dir;
    float inner;
    float outer;
};

uniform Light points[POINTS];
uniform Spot spot;

out vec4 color;

// the same for all lights, set in main
vec3 n;
vec3 v;
vec3 diff;
vec3 spec;

// fades a light with the distance
float attenuation(vec3 toLight, vec3 k) {
    float d = length(toLight);
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// 1 in the inner cone, 0 outside of the outer cone
float spotIntensity(vec3 l, vec3 direction, float inner, float outer) {
    float cosTheta = dot(-l, normalize(direction));
    float cosInner = cos(inner);
    float cosOuter = cos(outer);
    return clamp((cosTheta - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
}

// diffuse and specular part (Blinn-Phong) for one light
vec3 reflected(vec3 l, vec3 lightColor) {
    float cosAlpha = max(dot(n, l), 0.0);
    vec3 h = normalize(l + v);
    float cosBeta = max(dot(n, h), 0.0);
    return (diff * cosAlpha + spec * pow(cosBeta, shininess)) * lightColor;
}

vec3 pointLight(vec3 toLight, vec3 lightColor, vec3 k) {
    vec3 l = normalize(toLight);
    return reflected(l, lightColor * attenuation(toLight, k));
}

vec3 spotLight(vec3 toLight, vec3 lightColor, vec3 k, vec3 direction, float inner, float outer) {
    vec3 l = normalize(toLight);
    float intensity = spotIntensity(l, direction, inner, outer);
    return reflected(l, lightColor * intensity * attenuation(toLight, k));
}

void main() {
    vec3 emit = texture(texEmit, tc).rgb;
    diff = texture(texDiff, tc).rgb;
    spec = texture(texSpec, tc).rgb;
    n = normalize(normalView);
    v = normalize(toCamera);

    vec3 sum = emit * tint;
    for (int i = 0; i < POINTS; i++) {
        sum += pointLight(toPoints[i], points[i].color, points[i].att);
    }
    sum += spotLight(toSpot, spot.color, spot.att, spot.dir, spot.inner, spot.outer);
    color = vec4(sum, 1.0);
}
