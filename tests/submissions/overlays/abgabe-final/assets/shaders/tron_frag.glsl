#version 330 core
#define MAX_POINT_LIGHTS 10

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
    vec3 direction;
    float cosInner;
    float cosOuter;
};

in vec3 fragPos;
in vec3 fragNormal;
in vec2 fragTc;

uniform mat4 view;

uniform sampler2D material_emit;
uniform sampler2D material_diff;
uniform sampler2D material_spec;
uniform float material_shininess;
uniform vec3 emissionColor;

uniform PointLight pointLights[MAX_POINT_LIGHTS];
uniform int pointLightCount;
uniform SpotLight spotLight;

out vec4 color;

const float AMBIENT = 0.03;

float attenuationFactor(vec3 k, float d) {
    return 1.0 / (k.x + k.y * d + k.z * (d * d));
}

// M_d * cos(alpha) + M_s * cos(beta)^k
vec3 phong(vec3 N, vec3 L, vec3 V, vec3 Md, vec3 Ms) {
    vec3 H = normalize(L + V);
    float cosAlpha = max(dot(N, L), 0.0);
    float cosBeta = max(dot(N, H), 0.0);
    return Md * cosAlpha + Ms * pow(cosBeta, material_shininess);
}

void main() {
    vec3 Me = texture(material_emit, fragTc).rgb;
    vec3 Md = texture(material_diff, fragTc).rgb;
    vec3 Ms = texture(material_spec, fragTc).rgb;

    vec3 N = normalize(fragNormal);
    vec3 toCamera = -fragPos;
    vec3 V = normalize(toCamera);

    vec3 sum = Me * emissionColor + Md * AMBIENT;

    for (int i = 0; i < pointLightCount; i++) {
        vec3 toLight = (view * vec4(pointLights[i].position, 1.0)).xyz - fragPos;
        float d = length(toLight);
        vec3 L = normalize(toLight);
        sum += phong(N, L, V, Md, Ms) * pointLights[i].color * attenuationFactor(pointLights[i].attenuation, d);
    }

    vec3 toSpot = (view * vec4(spotLight.position, 1.0)).xyz - fragPos;
    float spotDist = length(toSpot);
    vec3 S = normalize(toSpot);
    float cosTheta = dot(S, normalize(spotLight.direction));
    float intensity = clamp((cosTheta - spotLight.cosOuter) / (spotLight.cosInner - spotLight.cosOuter), 0.0, 1.0);
    sum += phong(N, S, V, Md, Ms) * spotLight.color * intensity * attenuationFactor(spotLight.attenuation, spotDist);

    color = vec4(sum, 1.0);
}
