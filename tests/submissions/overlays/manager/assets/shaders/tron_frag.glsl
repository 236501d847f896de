#version 330 core

#define MAX_LIGHTS 8

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;   // constant, linear, quadratic
};

struct SpotLight {
    vec3 position;
    vec3 direction;
    vec3 color;
    vec3 attenuation;
    float innerAngle;   // radians
    float outerAngle;
};

struct Material {
    sampler2D diffuse;
    sampler2D specular;
    sampler2D emission;
    float shininess;
};

in VertexData {
    vec3 position;
    vec3 normal;
    vec2 texCoord;
} v_In;

uniform PointLight u_PointLights[MAX_LIGHTS];
uniform int u_PointLightCount;
uniform SpotLight u_SpotLights[MAX_LIGHTS];
uniform int u_SpotLightCount;
uniform vec3 u_AmbientLight;

uniform Material u_Material;
uniform vec3 u_EmissionColor;
uniform vec3 u_CameraPosition;

out vec4 o_Color;

float attenuate(vec3 k, float dist) {
    return 1.0 / (k.x + k.y * dist + k.z * dist * dist);
}

float coneFactor(SpotLight light, vec3 L) {
    float theta = dot(L, normalize(-light.direction));
    float gamma = cos(light.innerAngle);
    float phi = cos(light.outerAngle);
    return clamp((theta - phi) / (gamma - phi), 0.0, 1.0);
}

// Blinn-Phong, without the colour of the light
vec3 blinnPhong(vec3 N, vec3 L, vec3 V) {
    float NdotL = max(dot(N, L), 0.0);
    vec3 diffuse = NdotL * texture(u_Material.diffuse, v_In.texCoord).rgb;
    vec3 H = normalize(L + V);
    float NdotH = max(dot(N, H), 0.0);
    vec3 specular = pow(NdotH, u_Material.shininess) * texture(u_Material.specular, v_In.texCoord).rgb;
    return diffuse + specular;
}

void main() {
    vec3 N = normalize(v_In.normal);
    vec3 V = normalize(u_CameraPosition - v_In.position);

    vec3 result = u_AmbientLight * texture(u_Material.diffuse, v_In.texCoord).rgb;

    for (int i = 0; i < u_PointLightCount; i++) {
        vec3 toLight = u_PointLights[i].position - v_In.position;
        float att = attenuate(u_PointLights[i].attenuation, length(toLight));
        result += blinnPhong(N, normalize(toLight), V) * att * u_PointLights[i].color;
    }

    for (int i = 0; i < u_SpotLightCount; i++) {
        vec3 toLight = u_SpotLights[i].position - v_In.position;
        vec3 L = normalize(toLight);
        float intensity = coneFactor(u_SpotLights[i], L) * attenuate(u_SpotLights[i].attenuation, length(toLight));
        result += blinnPhong(N, L, V) * intensity * u_SpotLights[i].color;
    }

    result += u_EmissionColor * texture(u_Material.emission, v_In.texCoord).rgb;
    o_Color = vec4(result, 1.0);
}
