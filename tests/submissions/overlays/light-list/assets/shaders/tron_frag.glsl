#version 330 core

#define NR_POINT_LIGHTS 5
#define NR_SPOT_LIGHTS 1

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    vec3 position;
    vec3 direction;
    vec3 color;
    vec3 attenuation;
    float cosInner;
    float cosOuter;
};

struct Material {
    sampler2D diffuse;
    sampler2D specular;
    sampler2D emissive;
    float shininess;
};

in vec3 fragPos;
in vec2 texCoord;
in vec3 fragNormal;

uniform mat4 view;
uniform Material material;
uniform vec3 emitColor;
uniform PointLight pointLights[NR_POINT_LIGHTS];
uniform SpotLight spotLights[NR_SPOT_LIGHTS];

out vec4 fragColor;

// light position comes in world space, everything here is in view space
vec3 getToLight(vec3 lightPos) {
    vec4 lightView = view * vec4(lightPos, 1.0);
    return lightView.xyz - fragPos;
}

float getAttenuation(float d, vec3 k) {
    return 1.0 / (k.x + k.y * d + k.z * pow(d, 2.0));
}

// Blinn-Phong (4.7)
vec3 calcBlinnPhong(vec3 N, vec3 L, vec3 V, vec3 diffTex, vec3 specTex) {
    float cosAlpha = dot(N, L);
    if (cosAlpha <= 0.0) {
        return vec3(0.0);
    }
    // vec3 R = reflect(-L, N);
    // float cosBeta = max(dot(R, V), 0.0);
    vec3 H = normalize(L + V);
    float cosBeta = max(dot(N, H), 0.0);
    return diffTex * cosAlpha + specTex * pow(cosBeta, material.shininess);
}

vec3 calcPointLight(PointLight light, vec3 N, vec3 V, vec3 diffTex, vec3 specTex) {
    vec3 toLight = getToLight(light.position);
    float att = getAttenuation(length(toLight), light.attenuation);
    return calcBlinnPhong(N, normalize(toLight), V, diffTex, specTex) * light.color * att;
}

vec3 calcSpotLight(SpotLight light, vec3 N, vec3 V, vec3 diffTex, vec3 specTex) {
    vec3 toLight = getToLight(light.position);
    vec3 L = normalize(toLight);
    float theta = dot(-L, normalize(light.direction));
    float epsilon = light.cosInner - light.cosOuter;
    float intensity = clamp((theta - light.cosOuter) / epsilon, 0.0, 1.0);
    float att = getAttenuation(length(toLight), light.attenuation);
    return calcBlinnPhong(N, L, V, diffTex, specTex) * light.color * intensity * att;
}

void main() {
    vec3 diffTex = vec3(texture(material.diffuse, texCoord));
    vec3 specTex = vec3(texture(material.specular, texCoord));
    vec3 emitTex = vec3(texture(material.emissive, texCoord));

    vec3 N = normalize(fragNormal);
    vec3 V = normalize(-fragPos);

    vec3 light = vec3(0.0);
    for (int i = 0; i < NR_POINT_LIGHTS; i++) {
        light += calcPointLight(pointLights[i], N, V, diffTex, specTex);
    }
    for (int i = 0; i < NR_SPOT_LIGHTS; i++) {
        light += calcSpotLight(spotLights[i], N, V, diffTex, specTex);
    }

    vec3 emission = emitTex * emitColor;
    fragColor = vec4(emission + light, 1.0);
}
