#version 330 core

#define MAX_LIGHTS 8

struct Light {
    vec3 pos;
    vec3 col;
    vec3 att;
};

in vec2 vTexCoord;
in vec3 vNormal;
in vec3 vToCamera;
in vec3 vToLight[MAX_LIGHTS];
in vec3 vToSpot;

// material
uniform sampler2D emit;
uniform sampler2D diff;
uniform sampler2D spec;
uniform float shininess;
uniform vec3 tint;

// lights
uniform Light lights[MAX_LIGHTS];
uniform int lightCount;
uniform Light spot;
uniform vec3 spotDir;
uniform float spotInner;
uniform float spotOuter;

out vec4 color;

float fade(float d, vec3 k) {
    return 1.0 / (k.x + d * (k.y + d * k.z));
}

float cone(vec3 L) {
    float cosTheta = dot(normalize(spotDir), -L);
    float cosInner = cos(spotInner);
    float cosOuter = cos(spotOuter);
    return clamp((cosTheta - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
}

vec3 lit(vec3 N, vec3 V, vec3 toLight, vec3 lightColor) {
    vec3 L = normalize(toLight);
    float NdotL = dot(N, L);
    if (NdotL <= 0.0) return vec3(0.0);

    vec3 H = normalize(L + V);
    float NdotH = max(dot(N, H), 0.0);
    vec3 diffuse = texture(diff, vTexCoord).rgb * NdotL;
    vec3 specular = texture(spec, vTexCoord).rgb * pow(NdotH, shininess);
    return (diffuse + specular) * lightColor;
}

void main() {
    vec3 N = normalize(vNormal);
    vec3 V = normalize(vToCamera);

    vec3 result = texture(emit, vTexCoord).rgb * tint;

    // all point lights
    for (int i = 0; i < MAX_LIGHTS; i++) {
        if (i >= lightCount) break;
        vec3 lightColor = lights[i].col * fade(length(vToLight[i]), lights[i].att);
        result += lit(N, V, vToLight[i], lightColor);
    }

    // headlight
    vec3 spotColor = spot.col * fade(length(vToSpot), spot.att) * cone(normalize(vToSpot));
    result += lit(N, V, vToSpot, spotColor);

    color = vec4(result, 1.0);
}
