#version 330 core

in vec2 uv;
in vec3 normalVS;
in vec3 toCamera;
in vec3 toBikeLight;
in vec3 toFrontSpot;
in vec3 toLight1;
in vec3 toLight2;
in vec3 toLight3;

// Material
uniform sampler2D diffTex;
uniform sampler2D emitTex;
uniform sampler2D specTex;
uniform float shininess;
uniform vec2 tcMultiplier;
uniform vec3 emitColor;

// Lichter
uniform vec3 bikeLight_color;
uniform vec3 frontSpot_color;
uniform vec3 frontSpot_direction;
uniform float frontSpot_inner;
uniform float frontSpot_outer;
uniform vec3 light1_color;
uniform vec3 light2_color;
uniform vec3 light3_color;

out vec4 color;

const float GAMMA = 2.2;

vec3 gamma(vec3 c) {
    return pow(c, vec3(1.0 / GAMMA));
}

vec3 invgamma(vec3 c) {
    return pow(c, vec3(GAMMA));
}

vec3 shade(vec3 n, vec3 l, vec3 v, vec3 dif, vec3 spec, float shine) {
    vec3 diffuse = dif * max(0.0, dot(n, l));
    vec3 halfDir = normalize(v + l);
    float cosb = max(0.0, dot(n, halfDir));
    vec3 specular = spec * pow(cosb, shine);
    return diffuse + specular;
}

float attenuate(float len) {
    return 1.0 / (len * len);
}

vec3 pointLightIntensity(vec3 lightColor, float len) {
    return lightColor * attenuate(len);
}

vec3 spotLightIntensity(vec3 lightColor, float len, vec3 sp, vec3 spDir) {
    float cosTheta = dot(sp, normalize(spDir));
    float intensity = clamp((cosTheta - frontSpot_outer) / (frontSpot_inner - frontSpot_outer), 0.0, 1.0);
    return lightColor * attenuate(len) * intensity;
}

void main() {
    vec2 tc = uv * tcMultiplier;
    vec3 dif = invgamma(texture(diffTex, tc).rgb);
    vec3 emit = invgamma(texture(emitTex, tc).rgb);
    vec3 spec = texture(specTex, tc).rgb;

    vec3 n = normalize(normalVS);
    vec3 v = normalize(toCamera);
    vec3 lBike = normalize(toBikeLight);
    vec3 lSpot = normalize(toFrontSpot);
    vec3 l1 = normalize(toLight1);
    vec3 l2 = normalize(toLight2);
    vec3 l3 = normalize(toLight3);

    vec3 result = emit * emitColor;
    result += shade(n, lBike, v, dif, spec, shininess) * pointLightIntensity(bikeLight_color, length(toBikeLight));
    result += shade(n, lSpot, v, dif, spec, shininess) * spotLightIntensity(frontSpot_color, length(toFrontSpot), -lSpot, frontSpot_direction);
    result += shade(n, l1, v, dif, spec, shininess) * pointLightIntensity(light1_color, length(toLight1));
    result += shade(n, l2, v, dif, spec, shininess) * pointLightIntensity(light2_color, length(toLight2));
    result += shade(n, l3, v, dif, spec, shininess) * pointLightIntensity(light3_color, length(toLight3));

    color = vec4(gamma(result), 1.0);
}
