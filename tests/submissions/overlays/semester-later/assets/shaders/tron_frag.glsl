#version 330 core

const int MAX_LAMPS = 12;
const float GAMMA = 2.2;
const float AMBIENT = 0.01;

// VS = view space
struct Lamp {
    vec3 positionVS;
    vec3 radiance;
};

in vec3 fragmentVS;
in vec3 normalVS;
in vec2 uv;

// material
uniform sampler2D albedoMap;
uniform sampler2D glossMap;
uniform sampler2D glowMap;
uniform float glossExponent;
uniform vec3 glowTint;

// lights
uniform Lamp lamps[MAX_LAMPS];
uniform int lampCount;
uniform Lamp headlamp;
uniform vec3 headlampAxisVS;
uniform vec2 headlampCone;   // cosine of the inner angle, cosine of the outer angle

out vec4 pixel;

vec3 toLinear(vec3 color) {
    return pow(color, vec3(GAMMA));
}

vec3 toScreen(vec3 color) {
    return pow(color, vec3(1.0 / GAMMA));
}

// diffuse + specular part of one light
vec3 shade(Lamp lamp, vec3 normal, vec3 albedo, vec3 gloss) {
    vec3 toLamp = lamp.positionVS - fragmentVS;
    vec3 lampDir = normalize(toLamp);
    vec3 eyeDir = normalize(-fragmentVS);   // the camera is the origin of view space

    float cosAlpha = max(dot(normal, lampDir), 0.0);

    // Blinn-Phong
    vec3 halfway = normalize(lampDir + eyeDir);
    float cosBeta = max(dot(normal, halfway), 0.0);

    vec3 diffuse = albedo * cosAlpha;
    vec3 specular = gloss * pow(cosBeta, glossExponent);

    // inverse square law
    float attenuation = 1.0 / dot(toLamp, toLamp);
    return (diffuse + specular) * lamp.radiance * attenuation;
}

// 1 inside of the inner cone, 0 outside of the outer cone
float coneIntensity() {
    vec3 fromLamp = normalize(fragmentVS - headlamp.positionVS);
    float cosTheta = dot(fromLamp, normalize(headlampAxisVS));
    return clamp((cosTheta - headlampCone.y) / (headlampCone.x - headlampCone.y), 0.0, 1.0);
}

void main() {
    vec3 albedo = toLinear(texture(albedoMap, uv).rgb);
    vec3 gloss = texture(glossMap, uv).rgb;
    vec3 glow = toLinear(texture(glowMap, uv).rgb);
    vec3 normal = normalize(normalVS);

    vec3 result = glow * glowTint + albedo * AMBIENT;
    for (int i = 0; i < lampCount; i++) {
        result += shade(lamps[i], normal, albedo, gloss);
    }
    result += shade(headlamp, normal, albedo, gloss) * coneIntensity();

    pixel = vec4(toScreen(result), 1.0);
}
