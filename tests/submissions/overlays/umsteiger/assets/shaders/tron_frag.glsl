#version 330 core

const int LIGHTS = 6;

in vec2 vTexCoord;
in vec3 vNormal;
in vec3 vToCamera;
in vec3 vToLight[LIGHTS];

uniform sampler2D uTexEmissive;
uniform sampler2D uTexDiffuse;
uniform sampler2D uTexSpecular;
uniform float uShininess;
uniform vec3 uEmissionColor;

uniform vec3 uLightColor[LIGHTS];
uniform vec3 uLightAttenuation[LIGHTS];
uniform int uSpotIndex;
uniform vec3 uSpotAxis;
uniform float uSpotCosInner;
uniform float uSpotCosOuter;

out vec4 fragColor;

float getAttenuation(vec3 toLight, vec3 k) {
    float dist = length(toLight);
    return 1.0 / (k.x + dist * (k.y + dist * k.z));
}

float getSpotIntensity(vec3 lightDir) {
    float cosTheta = dot(normalize(uSpotAxis), lightDir);
    float intensity = (cosTheta - uSpotCosOuter) / (uSpotCosInner - uSpotCosOuter);
    return clamp(intensity, 0.0, 1.0);
}

void main() {
    vec3 diffuseColor = texture(uTexDiffuse, vTexCoord).rgb;
    vec3 specularColor = texture(uTexSpecular, vTexCoord).rgb;
    vec3 emissiveColor = texture(uTexEmissive, vTexCoord).rgb;

    vec3 normal = normalize(vNormal);
    vec3 viewDir = normalize(vToCamera);

    vec3 result = emissiveColor * uEmissionColor;
    for (int i = 0; i < LIGHTS; i++) {
        vec3 lightDir = normalize(vToLight[i]);
        float nDotL = dot(normal, lightDir);
        if (nDotL <= 0.0) {
            continue; // light is behind the surface
        }

        vec3 halfVector = normalize(lightDir + viewDir);
        float nDotH = max(dot(normal, halfVector), 0.0);
        vec3 terms = diffuseColor * nDotL + specularColor * pow(nDotH, uShininess);

        terms *= getAttenuation(vToLight[i], uLightAttenuation[i]);
        if (i == uSpotIndex) {
            terms *= getSpotIntensity(lightDir);
        }
        result += terms * uLightColor[i];
    }
    fragColor = vec4(result, 1.0);
}
