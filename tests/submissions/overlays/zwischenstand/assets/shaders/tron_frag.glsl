#version 330 core

#define MAX_CORNER_LIGHTS 8

struct PointLight {
    vec3 position;      // world space!
    vec3 color;
    vec3 attenuation;   // x = Kc, y = Kl, z = Kq
};

struct SpotLight {
    vec3 position;      // world space!
    vec3 color;
    vec3 attenuation;
    vec3 direction;     // view space
    float innerAngle;
    float outerAngle;
};

in vec3 viewPosition;
in vec3 viewNormal;
in vec2 texCoord;
in vec3 toCamera;
in vec3 toBikeLight;
in vec3 toHeadLight;

uniform mat4 viewMatrix;

// Material
uniform sampler2D emissiveMap;
uniform sampler2D diffuseMap;
uniform sampler2D specularMap;
uniform float shininess;

// Aufgabe 4.4
uniform vec3 emissionColor;

// Lichter
uniform PointLight bikeLight;
uniform SpotLight headLight;
uniform PointLight cornerLights[MAX_CORNER_LIGHTS];
uniform int cornerLightCount;

out vec4 fragColor;

// Term C: M_d * max(cos(alpha), 0)
vec3 calcDiffuse(vec3 normal, vec3 lightDir) {
    float cosAlpha = max(dot(normal, lightDir), 0.0);
    return texture(diffuseMap, texCoord).rgb * cosAlpha;
}

// Term D: M_s * max(cos(beta), 0)^k
vec3 calcSpecular(vec3 normal, vec3 lightDir, vec3 viewDir) {
    // Phong (4.2)
    // vec3 reflected = reflect(-lightDir, normal);
    // float cosBeta = max(dot(reflected, viewDir), 0.0);
    // Blinn-Phong (4.7)
    vec3 halfVector = normalize(lightDir + viewDir);
    float cosBeta = max(dot(normal, halfVector), 0.0);
    return texture(specularMap, texCoord).rgb * pow(cosBeta, shininess);
}

// Aufgabe 4.3.4
float calcAttenuation(vec3 toLight, vec3 k) {
    float d = length(toLight);
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// Aufgabe 4.3.3, Winkel sind schon im Bogenmass
float calcSpotIntensity(vec3 lightDir) {
    float cosTheta = dot(normalize(headLight.direction), -lightDir);
    float cosGamma = cos(headLight.innerAngle);
    float cosPhi = cos(headLight.outerAngle);
    // Formel vom Blatt, aber mit gamma und phi getauscht, sonst ist es innen dunkel
    float intensity = (cosTheta - cosPhi) / (cosGamma - cosPhi);
    return clamp(intensity, 0.0, 1.0);
}

void main() {
    vec3 normal = normalize(viewNormal);
    vec3 viewDir = normalize(toCamera);

    // Emission (A)
    vec3 result = texture(emissiveMap, texCoord).rgb * emissionColor;

    // Licht am Motorrad
    vec3 bikeDir = normalize(toBikeLight);
    vec3 bikeColor = bikeLight.color * calcAttenuation(toBikeLight, bikeLight.attenuation);
    result += (calcDiffuse(normal, bikeDir) + calcSpecular(normal, bikeDir, viewDir)) * bikeColor;

    // Scheinwerfer
    vec3 headDir = normalize(toHeadLight);
    vec3 headColor = headLight.color * calcSpotIntensity(headDir) * calcAttenuation(toHeadLight, headLight.attenuation);
    result += (calcDiffuse(normal, headDir) + calcSpecular(normal, headDir, viewDir)) * headColor;

    // Lichter in den Ecken (4.6)
    for (int i = 0; i < cornerLightCount; i++) {
        vec3 cornerPosition = (viewMatrix * vec4(cornerLights[i].position, 1.0)).xyz;
        vec3 toCorner = cornerPosition - viewPosition;
        vec3 cornerDir = normalize(toCorner);
        vec3 cornerColor = cornerLights[i].color * calcAttenuation(toCorner, cornerLights[i].attenuation);
        result += (calcDiffuse(normal, cornerDir) + calcSpecular(normal, cornerDir, viewDir)) * cornerColor;
    }

    fragColor = vec4(result, 1.0);
    // fragColor = vec4(abs(normal), 1.0);
}
