#version 330 core

#define CORNER_LIGHTS 4
#define GAMMA 2.2

in vec3 fragPosition;
in vec3 fragNormal;
in vec2 fragTexCoords;
in vec3 toCamera;
in vec3 toPointLight;
in vec3 toSpotLight;

uniform mat4 viewMatrix;

// Material
uniform sampler2D diffuseTexture;
uniform sampler2D specularTexture;
uniform sampler2D emissiveTexture;
uniform float materialShininess;
uniform vec3 emissionColor;

// PointLight
uniform vec3 pointLightColor;

// SpotLight
uniform vec3 spotLightColor;
uniform vec3 spotLightDirection;
uniform float spotLightInnerAngle;
uniform float spotLightOuterAngle;

// Ecken
uniform vec3 cornerLightPositions[CORNER_LIGHTS];
uniform vec3 cornerLightColors[CORNER_LIGHTS];

out vec4 fragColor;

// Licht wird erst gesammelt, die Texturen kommen am Ende dazu
vec3 diffuseLight = vec3(0.0);
vec3 specularLight = vec3(0.0);

void addLight(vec3 N, vec3 V, vec3 toLight, vec3 lightColor) {
    vec3 L = normalize(toLight);
    vec3 H = normalize(L + V);
    float d = length(toLight);
    vec3 incoming = lightColor / (d * d);

    diffuseLight += incoming * max(dot(N, L), 0.0);
    specularLight += incoming * pow(max(dot(N, H), 0.0), materialShininess);
}

float spotIntensity() {
    float cosTheta = dot(normalize(-toSpotLight), normalize(spotLightDirection));
    float cosInner = cos(spotLightInnerAngle);
    float cosOuter = cos(spotLightOuterAngle);
    return clamp((cosTheta - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
}

void main() {
    vec3 N = normalize(fragNormal);
    vec3 V = normalize(toCamera);

    // Lichter vom Motorrad
    addLight(N, V, toPointLight, pointLightColor);
    addLight(N, V, toSpotLight, spotLightColor * spotIntensity());

    // Ecken, die Vektoren werden hier berechnet (sonst zu viele Varyings)
    for (int i = 0; i < CORNER_LIGHTS; i++) {
        vec3 cornerPosition = (viewMatrix * vec4(cornerLightPositions[i], 1.0)).xyz;
        addLight(N, V, cornerPosition - fragPosition, cornerLightColors[i]);
    }

    // ambient
    diffuseLight += vec3(0.01);

    // Texturen linearisieren (Specular Map ist schon linear)
    vec3 diffuse = pow(texture(diffuseTexture, fragTexCoords).rgb, vec3(GAMMA));
    vec3 emission = pow(texture(emissiveTexture, fragTexCoords).rgb, vec3(GAMMA));
    vec3 specular = texture(specularTexture, fragTexCoords).rgb;

    vec3 result = emission * emissionColor + diffuse * diffuseLight + specular * specularLight;

    // Gammakorrektur
    fragColor = vec4(pow(result, vec3(1.0 / GAMMA)), 1.0);
}
