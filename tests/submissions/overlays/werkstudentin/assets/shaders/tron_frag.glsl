#version 330 core

#define LAMP_COUNT 5

struct Lamp {
    vec3 position; // world space
    vec3 radiance;
};

struct Headlamp {
    vec3 position; // world space
    vec3 radiance;
    vec3 axis;     // view space
    vec2 cone;     // cosines of the inner and the outer angle
};

in SurfacePoint {
    vec2 uv;
    vec3 normal;
    vec3 toEye;
    vec3 toLamp[LAMP_COUNT];
    vec3 toHeadlamp;
} point;

uniform Lamp lamps[LAMP_COUNT];
uniform Headlamp headlamp;

uniform sampler2D albedoMap;
uniform sampler2D mirrorMap;
uniform sampler2D emissionMap;
uniform float polish;
uniform vec3 emissionTint;

out vec4 pixel;

const float GAMMA = 2.2;

vec3 toLinear(vec3 stored) {
    return pow(stored, vec3(GAMMA));
}

vec3 toDisplay(vec3 linear) {
    return pow(linear, vec3(1.0 / GAMMA));
}

// inverse square law
float falloff(vec3 toLight) {
    return 1.0 / dot(toLight, toLight);
}

// 1 in the inner cone, 0 outside of the outer one, linear between them
float beam(vec3 l) {
    float cosTheta = dot(-l, normalize(headlamp.axis));
    return clamp((cosTheta - headlamp.cone.y) / (headlamp.cone.x - headlamp.cone.y), 0.0, 1.0);
}

// Lambert
float matte(vec3 n, vec3 l) {
    return max(dot(n, l), 0.0);
}

// Blinn-Phong
float shine(vec3 n, vec3 l, vec3 v) {
    vec3 h = normalize(l + v);
    return pow(max(dot(n, h), 0.0), polish);
}

void main() {
    vec3 albedo = toLinear(texture(albedoMap, point.uv).rgb);
    vec3 emission = toLinear(texture(emissionMap, point.uv).rgb);
    vec3 mirror = texture(mirrorMap, point.uv).rgb;

    vec3 n = normalize(point.normal);
    vec3 v = normalize(point.toEye);

    // light that arrives here, for the matte and for the shiny part of the surface
    vec3 matteLight = vec3(0.0);
    vec3 shinyLight = vec3(0.0);

    for (int i = 0; i < LAMP_COUNT; i++) {
        vec3 l = normalize(point.toLamp[i]);
        vec3 arriving = lamps[i].radiance * falloff(point.toLamp[i]);
        matteLight += arriving * matte(n, l);
        shinyLight += arriving * shine(n, l, v);
    }

    vec3 l = normalize(point.toHeadlamp);
    vec3 arriving = headlamp.radiance * falloff(point.toHeadlamp) * beam(l);
    matteLight += arriving * matte(n, l);
    shinyLight += arriving * shine(n, l, v);

    vec3 reflected = albedo * matteLight + mirror * shinyLight;
    pixel = vec4(toDisplay(emission * emissionTint + reflected), 1.0);
}
