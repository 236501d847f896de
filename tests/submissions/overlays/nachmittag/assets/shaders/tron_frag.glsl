#version 330 core
out vec4 FragColor;

struct Material {
    sampler2D diffuseMap;
    sampler2D specularMap;
    sampler2D emissionMap;
    float shininess;
};

// the positions are in world space, see lightToView()
struct PointLight {
    vec3 worldPosition;
    vec3 color;

    float constant;
    float linear;
    float quadratic;
};

struct SpotLight {
    vec3 worldPosition;
    vec3 viewDirection;
    vec3 color;

    // in radians
    float cutOffAngle;
    float outerCutOffAngle;

    float constant;
    float linear;
    float quadratic;
};

#define NR_CORNER_LAMPS 4

in vec3 FragPos;
in vec3 Normal;
in vec2 TexCoords;

uniform Material mtl;
uniform vec3 emissionTint;
uniform mat4 matView;

uniform PointLight bikeLamp;
uniform SpotLight headLamp;
uniform PointLight cornerLamps[NR_CORNER_LAMPS];

// in view space the camera sits in the origin
const vec3 viewPos = vec3(0.0, 0.0, 0.0);

const float ambientStrength = 0.04;

vec3 lightToView(vec3 worldPosition)
{
    return vec3(matView * vec4(worldPosition, 1.0));
}

float calcAttenuation(float distance, float constant, float linear, float quadratic)
{
    return 1.0 / (constant + linear * distance + quadratic * (distance * distance));
}

vec3 calcPointLight(PointLight light, vec3 norm, vec3 viewDir)
{
    vec3 lightPos = lightToView(light.worldPosition);
    vec3 lightDir = normalize(lightPos - FragPos);

    // diffuse
    float diff = max(dot(norm, lightDir), 0.0);
    vec3 diffuse = light.color * (diff * vec3(texture(mtl.diffuseMap, TexCoords)));

    // specular
    // vec3 reflectDir = reflect(-lightDir, norm);
    // float spec = pow(max(dot(viewDir, reflectDir), 0.0), mtl.shininess);
    vec3 halfwayDir = normalize(lightDir + viewDir);
    float spec = pow(max(dot(norm, halfwayDir), 0.0), mtl.shininess);
    vec3 specular = light.color * (spec * vec3(texture(mtl.specularMap, TexCoords)));

    // attenuation
    float attenuation = calcAttenuation(length(lightPos - FragPos), light.constant, light.linear, light.quadratic);
    diffuse *= attenuation;
    specular *= attenuation;

    return diffuse + specular;
}

vec3 calcSpotLight(SpotLight light, vec3 norm, vec3 viewDir)
{
    vec3 lightPos = lightToView(light.worldPosition);
    vec3 lightDir = normalize(lightPos - FragPos);

    // diffuse
    float diff = max(dot(norm, lightDir), 0.0);
    vec3 diffuse = light.color * (diff * vec3(texture(mtl.diffuseMap, TexCoords)));

    // specular
    vec3 halfwayDir = normalize(lightDir + viewDir);
    float spec = pow(max(dot(norm, halfwayDir), 0.0), mtl.shininess);
    vec3 specular = light.color * (spec * vec3(texture(mtl.specularMap, TexCoords)));

    // spotlight (soft edges)
    float theta = dot(lightDir, normalize(-light.viewDirection));
    float epsilon = cos(light.cutOffAngle) - cos(light.outerCutOffAngle);
    float intensity = clamp((theta - cos(light.outerCutOffAngle)) / epsilon, 0.0, 1.0);
    diffuse *= intensity;
    specular *= intensity;

    // attenuation
    float attenuation = calcAttenuation(length(lightPos - FragPos), light.constant, light.linear, light.quadratic);
    diffuse *= attenuation;
    specular *= attenuation;

    return diffuse + specular;
}

void main()
{
    vec3 norm = normalize(Normal);
    vec3 viewDir = normalize(viewPos - FragPos);

    // ambient and emission, only once and not for each light
    vec3 ambient = ambientStrength * vec3(texture(mtl.diffuseMap, TexCoords));
    vec3 emission = emissionTint * vec3(texture(mtl.emissionMap, TexCoords));
    vec3 result = ambient + emission;

    // the lights of the motorcycle
    result += calcPointLight(bikeLamp, norm, viewDir);
    result += calcSpotLight(headLamp, norm, viewDir);

    // the corners
    for (int i = 0; i < NR_CORNER_LAMPS; i++)
        result += calcPointLight(cornerLamps[i], norm, viewDir);

    FragColor = vec4(result, 1.0);
    // FragColor = vec4(norm * 0.5 + 0.5, 1.0); // show normals
}
