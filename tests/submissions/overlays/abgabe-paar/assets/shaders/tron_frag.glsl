#version 330 core
#define MAX_POINT_LIGHTS 10

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 att;
};

struct SpotLight {
    vec3 position;
    vec3 color;
    vec3 att;
    vec3 direction;
    float cosInner;
    float cosOuter;
};

in vec3 fragPos;
in vec3 fragNormal;
in vec2 texCoord;

uniform mat4 view;

uniform sampler2D material_diffuse;
uniform sampler2D material_emissive;
uniform sampler2D material_specular;
uniform float material_shininess;
uniform vec3 emissionColor;

uniform PointLight pointLights[MAX_POINT_LIGHTS];
uniform int numPointLights;
uniform SpotLight headlight;

out vec4 fragColor;

vec3 normal;
vec3 toCamera;
vec3 diffuseMap;
vec3 specularMap;

float attenuation(float d, vec3 att) {
    return 1.0 / (att.x + att.y * d + att.z * d * d);
}

vec3 shade(vec3 toLight, vec3 lightColor) {
    vec3 l = normalize(toLight);
    float cosAlpha = max(dot(normal, l), 0.0);
    if (cosAlpha == 0.0) return vec3(0.0);
    vec3 h = normalize(l + toCamera);
    float cosBeta = max(dot(normal, h), 0.0);
    return (diffuseMap * cosAlpha + specularMap * pow(cosBeta, material_shininess)) * lightColor;
}

vec3 calcPointLight(PointLight light) {
    vec3 toLight = vec3(view * vec4(light.position, 1.0)) - fragPos;
    float d = length(toLight);
    return shade(toLight, light.color * attenuation(d, light.att));
}

vec3 calcSpotLight(SpotLight light) {
    vec3 toLight = vec3(view * vec4(light.position, 1.0)) - fragPos;
    float d = length(toLight);
    vec3 direction = normalize(vec3(view * vec4(light.direction, 0.0)));
    float cosTheta = dot(normalize(toLight), -direction);
    float intensity = clamp((cosTheta - light.cosOuter) / (light.cosInner - light.cosOuter), 0.0, 1.0);
    return shade(toLight, light.color * intensity * attenuation(d, light.att));
}

void main() {
    normal = normalize(fragNormal);
    toCamera = normalize(-fragPos);
    diffuseMap = texture(material_diffuse, texCoord).rgb;
    specularMap = texture(material_specular, texCoord).rgb;

    vec3 result = texture(material_emissive, texCoord).rgb * emissionColor;
    for (int i = 0; i < numPointLights; i++) {
        result += calcPointLight(pointLights[i]);
    }
    result += calcSpotLight(headlight);
    fragColor = vec4(result, 1.0);
}
