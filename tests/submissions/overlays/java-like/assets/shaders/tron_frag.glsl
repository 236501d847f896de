#version 330 core

const int LIGHT_COUNT = 6;
const int SPOT = 1;

in vec2 texCoord;
in vec3 worldNormal;
in vec3 toView;
in vec3 toLight[LIGHT_COUNT];

uniform sampler2D emissiveTexture;
uniform sampler2D diffuseTexture;
uniform sampler2D specularTexture;
uniform float shininess;
uniform vec3 overlayColor;
uniform vec3 ambientColor;

uniform vec3 lightColor[LIGHT_COUNT];
uniform vec3 lightAttenuation[LIGHT_COUNT];
uniform vec3 spotDirection;
uniform float spotInnerAngle;
uniform float spotOuterAngle;

out vec4 fragColor;

float getAttenuation(int i) {
    float distanceToLight = length(toLight[i]);
    float constant = lightAttenuation[i].x;
    float linear = lightAttenuation[i].y * distanceToLight;
    float quadratic = lightAttenuation[i].z * distanceToLight * distanceToLight;
    return 1.0 / (constant + linear + quadratic);
}

float getSpotIntensity(vec3 direction) {
    float cosTheta = dot(-direction, normalize(spotDirection));
    float cosInner = cos(spotInnerAngle);
    float cosOuter = cos(spotOuterAngle);
    float intensity = (cosTheta - cosOuter) / (cosInner - cosOuter);
    return clamp(intensity, 0.0, 1.0);
}

vec3 getLightColor(int i, vec3 direction) {
    vec3 result = lightColor[i] * getAttenuation(i);
    if (i == SPOT) {
        result *= getSpotIntensity(direction);
    }
    return result;
}

void main() {
    vec3 emissive = texture(emissiveTexture, texCoord).rgb;
    vec3 diffuse = texture(diffuseTexture, texCoord).rgb;
    vec3 specular = texture(specularTexture, texCoord).rgb;

    vec3 normal = normalize(worldNormal);
    vec3 viewDirection = normalize(toView);

    vec3 sum = emissive * overlayColor + diffuse * ambientColor;
    for (int i = 0; i < LIGHT_COUNT; i++) {
        vec3 lightDirection = normalize(toLight[i]);
        vec3 color = getLightColor(i, lightDirection);

        float diffuseFactor = max(dot(normal, lightDirection), 0.0);
        float specularFactor = 0.0;
        if (diffuseFactor > 0.0) {
            vec3 halfVector = normalize(lightDirection + viewDirection);
            specularFactor = pow(max(dot(normal, halfVector), 0.0), shininess);
        }
        sum += (diffuse * diffuseFactor + specular * specularFactor) * color;
    }
    fragColor = vec4(sum, 1.0);
}
