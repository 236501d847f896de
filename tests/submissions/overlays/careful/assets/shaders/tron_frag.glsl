#version 330 core

// must be the same as in tron_vert.glsl and PointLight.MAX_POINT_LIGHTS
#define MAX_POINT_LIGHTS 8

// B: the ambient light L_a, very weak
const vec3 AMBIENT_LIGHT = vec3(0.02);

// from the vertex shader (view space, not normalized)
in vec2 fragTexCoord;
in vec3 fragNormal;
in vec3 toCamera;
in vec3 toPointLight[MAX_POINT_LIGHTS];
in vec3 toSpotLight;

// material
uniform sampler2D emissiveMap;   // M_e
uniform sampler2D diffuseMap;    // M_d
uniform sampler2D specularMap;   // M_s
uniform float shininess;         // k
uniform vec3 emissiveTint;       // colours the emission (task 4.4)

// point lights
uniform int numPointLights;
uniform vec3 pointLightColors[MAX_POINT_LIGHTS];
uniform vec3 pointLightAttenuations[MAX_POINT_LIGHTS];   // (K_c, K_l, K_q)

// the headlight
struct Spot {
    vec3 color;
    vec3 attenuation;   // (K_c, K_l, K_q)
    vec3 direction;     // view space
    float cosInner;     // cos(gamma)
    float cosOuter;     // cos(phi)
};
uniform Spot spotLight;

out vec4 fragColor;

// sums over all lights (terms C and D without the material)
vec3 diffuseSum = vec3(0.0);
vec3 specularSum = vec3(0.0);

// max(cos alpha, 0)
float diffuseFactor(vec3 N, vec3 L) {
    return max(dot(N, L), 0.0);
}

// max(cos beta, 0)^k with the half vector (Blinn-Phong, task 4.7)
float specularFactor(vec3 N, vec3 L, vec3 V) {
    vec3 H = normalize(L + V);
    float cosBeta = max(dot(N, H), 0.0);
    return pow(cosBeta, shininess);
}

// F_att (task 4.3.4)
float attenuationFactor(vec3 k, float d) {
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// the intensity I of the headlight: 1 inside, 0 outside, linear in between (task 4.3.3)
float spotIntensity(vec3 L) {
    vec3 fromLight = -L;
    float cosTheta = dot(fromLight, normalize(spotLight.direction));
    float intensity = (cosTheta - spotLight.cosOuter) / (spotLight.cosInner - spotLight.cosOuter);
    return clamp(intensity, 0.0, 1.0);
}

// adds one light to the sums
void addLight(vec3 N, vec3 L, vec3 V, vec3 lightColor) {
    diffuseSum += lightColor * diffuseFactor(N, L);
    specularSum += lightColor * specularFactor(N, L, V);
}

void main() {
    vec3 M_e = texture(emissiveMap, fragTexCoord).rgb;
    vec3 M_d = texture(diffuseMap, fragTexCoord).rgb;
    vec3 M_s = texture(specularMap, fragTexCoord).rgb;

    vec3 N = normalize(fragNormal);
    vec3 V = normalize(toCamera);

    // all point lights
    for (int i = 0; i < numPointLights; i++) {
        vec3 L = normalize(toPointLight[i]);
        float attenuation = attenuationFactor(pointLightAttenuations[i], length(toPointLight[i]));
        addLight(N, L, V, pointLightColors[i] * attenuation);
    }

    // the headlight
    vec3 L = normalize(toSpotLight);
    float attenuation = attenuationFactor(spotLight.attenuation, length(toSpotLight));
    addLight(N, L, V, spotLight.color * spotIntensity(L) * attenuation);

    // L_O = A + B + C + D
    vec3 emissive = M_e * emissiveTint;
    vec3 ambient = M_d * AMBIENT_LIGHT;
    vec3 diffuse = M_d * diffuseSum;
    vec3 specular = M_s * specularSum;
    fragColor = vec4(emissive + ambient + diffuse + specular, 1.0);
}
