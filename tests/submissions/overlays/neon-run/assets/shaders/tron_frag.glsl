#version 330 core

#define MAX_LIGHTS 8

struct Material {
    sampler2D diffuse;
    sampler2D specular;
    sampler2D emissive;
    float shininess;
};

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 k;
};

struct SpotLight {
    PointLight base;
    vec3 direction;
    float cosInner;
    float cosOuter;
};

in VS_OUT {
    vec3 position;
    vec3 normal;
    vec2 uv;
    vec4 moonPosition;
} vs;

uniform Material material;
uniform vec3 glowColor;

uniform PointLight pointLights[MAX_LIGHTS];
uniform int pointLightCount;
uniform SpotLight spotLight;

uniform sampler2D shadowMap;
uniform vec3 moonDirection;
uniform vec3 moonColor;

uniform vec3 fogColor;
uniform float fogStart;
uniform float fogEnd;

out vec4 fragColor;

vec3 N;
vec3 V;
vec3 diffuseMap;
vec3 specularMap;

// Blinn-Phong for light from direction L
vec3 blinnPhong(vec3 L) {
    float NdotL = dot(N, L);
    if (NdotL <= 0.0) return vec3(0.0);
    vec3 H = normalize(L + V);
    float highlight = pow(max(dot(N, H), 0.0), material.shininess);
    return diffuseMap * NdotL + specularMap * highlight;
}

vec3 calcPoint(PointLight light) {
    vec3 toLight = light.position - vs.position;
    float d = length(toLight);
    float attenuation = 1.0 / (light.k.x + light.k.y * d + light.k.z * d * d);
    return blinnPhong(toLight / d) * light.color * attenuation;
}

vec3 calcSpot(SpotLight light) {
    vec3 L = normalize(light.base.position - vs.position);
    float cosTheta = dot(L, normalize(-light.direction));
    float intensity = (cosTheta - light.cosOuter) / (light.cosInner - light.cosOuter);
    return calcPoint(light.base) * clamp(intensity, 0.0, 1.0);
}

float moonlight() {
    vec3 p = vs.moonPosition.xyz / vs.moonPosition.w * 0.5 + 0.5;
    if (p.z > 1.0) return 1.0;
    float nearest = texture(shadowMap, p.xy).r;
    return p.z - 0.003 > nearest ? 0.0 : 1.0;
}

void main() {
    N = normalize(vs.normal);
    V = normalize(-vs.position);
    diffuseMap = texture(material.diffuse, vs.uv).rgb;
    specularMap = texture(material.specular, vs.uv).rgb;

    vec3 result = texture(material.emissive, vs.uv).rgb * glowColor;
    for (int i = 0; i < pointLightCount; i++) {
        result += calcPoint(pointLights[i]);
    }
    result += calcSpot(spotLight);
    result += blinnPhong(normalize(moonDirection)) * moonColor * moonlight();

    float fog = clamp((length(vs.position) - fogStart) / (fogEnd - fogStart), 0.0, 1.0);
    fragColor = vec4(mix(result, fogColor, fog), 1.0);
}
