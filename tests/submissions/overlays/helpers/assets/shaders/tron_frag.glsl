#version 330 core
#define NR_POINT_LIGHTS 6
#define AMBIENT vec3(0.03)

struct Material {
    sampler2D diffuse;
    sampler2D specular;
    sampler2D emission;
    float shininess;
};

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
    float cutOff;
    float outerCutOff;
};

in VertexData {
    vec2 texCoords;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight[NR_POINT_LIGHTS];
    vec3 toSpotLight;
} vertexData;

uniform Material material;
uniform vec3 emissionColor;
uniform PointLight pointLights[NR_POINT_LIGHTS];
uniform SpotLight spotLight;

out vec4 FragColor;

float calcAttenuation(vec3 k, float distance) {
    return 1.0 / (k.x + k.y * distance + k.z * (distance * distance));
}

vec3 calcDiffuse(vec3 normal, vec3 lightDir, vec3 lightColor) {
    float diff = max(dot(normal, lightDir), 0.0);
    return lightColor * diff * texture(material.diffuse, vertexData.texCoords).rgb;
}

vec3 calcSpecular(vec3 normal, vec3 lightDir, vec3 viewDir, vec3 lightColor) {
    // no highlight on the side that faces away from the light
    if (dot(normal, lightDir) <= 0.0) {
        return vec3(0.0);
    }
    vec3 halfwayDir = normalize(lightDir + viewDir);
    float spec = pow(max(dot(normal, halfwayDir), 0.0), material.shininess);
    return lightColor * spec * texture(material.specular, vertexData.texCoords).rgb;
}

vec3 calcPointLight(PointLight light, vec3 toLight, vec3 normal, vec3 viewDir) {
    vec3 lightDir = normalize(toLight);
    float attenuation = calcAttenuation(light.attenuation, length(toLight));
    vec3 diffuse = calcDiffuse(normal, lightDir, light.color);
    vec3 specular = calcSpecular(normal, lightDir, viewDir, light.color);
    diffuse *= attenuation;
    specular *= attenuation;
    return diffuse + specular;
}

vec3 calcSpotLight(SpotLight light, vec3 toLight, vec3 normal, vec3 viewDir) {
    vec3 lightDir = normalize(toLight);
    float attenuation = calcAttenuation(light.attenuation, length(toLight));
    // soft edges
    float theta = dot(lightDir, normalize(-light.direction));
    float epsilon = light.cutOff - light.outerCutOff;
    float intensity = clamp((theta - light.outerCutOff) / epsilon, 0.0, 1.0);
    vec3 diffuse = calcDiffuse(normal, lightDir, light.color);
    vec3 specular = calcSpecular(normal, lightDir, viewDir, light.color);
    diffuse *= attenuation * intensity;
    specular *= attenuation * intensity;
    return diffuse + specular;
}

void main() {
    vec3 norm = normalize(vertexData.normal);
    vec3 viewDir = normalize(vertexData.toCamera);

    // emission and ambient
    vec3 result = emissionColor * texture(material.emission, vertexData.texCoords).rgb;
    result += AMBIENT * texture(material.diffuse, vertexData.texCoords).rgb;

    // point lights
    for (int i = 0; i < NR_POINT_LIGHTS; i++) {
        result += calcPointLight(pointLights[i], vertexData.toPointLight[i], norm, viewDir);
    }

    // spot light
    result += calcSpotLight(spotLight, vertexData.toSpotLight, norm, viewDir);

    FragColor = vec4(result, 1.0);
}
