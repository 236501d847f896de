#version 330 core

#define LIGHTS 6
#define SPOT 1

in vec2 vTexCoord;
in vec3 vNormal;
in vec3 vToCamera;
in vec3 vToLight[LIGHTS];

uniform sampler2D matEmissive;
uniform sampler2D matDiffuse;
uniform sampler2D matSpecular;
uniform float matShininess;
uniform vec3 emissionColor;

uniform vec3 lightColor[LIGHTS];
uniform vec3 spotBack;
uniform vec2 spotAngles;

out vec4 color;

const vec3 ambient = vec3(0.02);

vec3 toLinear(vec3 srgb) {
    return pow(srgb, vec3(2.2));
}

vec3 toSrgb(vec3 linear) {
    return pow(linear, vec3(1.0 / 2.2));
}

float inverseSquare(vec3 toLight) {
    float d = length(toLight);
    return 1.0 / (d * d);
}

float cone(vec3 l) {
    float theta = dot(l, normalize(spotBack));
    float gamma = cos(spotAngles.x);
    float phi = cos(spotAngles.y);
    return clamp((theta - phi) / (gamma - phi), 0.0, 1.0);
}

void main() {
    vec3 emissive = toLinear(texture(matEmissive, vTexCoord).rgb);
    vec3 diffuse = toLinear(texture(matDiffuse, vTexCoord).rgb);
    vec3 specular = toLinear(texture(matSpecular, vTexCoord).rgb);

    vec3 n = normalize(vNormal);
    vec3 v = normalize(vToCamera);

    vec3 sum = emissive * emissionColor + diffuse * ambient;
    for (int i = 0; i < LIGHTS; i++) {
        vec3 l = normalize(vToLight[i]);
        vec3 h = normalize(v + l);
        vec3 strength = lightColor[i] * inverseSquare(vToLight[i]);
        if (i == SPOT) {
            strength *= cone(l);
        }
        float lambert = max(dot(n, l), 0.0);
        float highlight = pow(max(dot(n, h), 0.0), matShininess);
        sum += (diffuse * lambert + specular * highlight) * strength;
    }
    color = vec4(toSrgb(sum), 1.0);
}
