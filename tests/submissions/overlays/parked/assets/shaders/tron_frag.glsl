#version 330 core

#define NUM_POINT_LIGHTS 5

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
    float innerCone;
    float outerCone;
};

//input from vertex shader
in struct VertexData {
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
} vertexData;

in vec3 toPointLight[NUM_POINT_LIGHTS];
in vec3 toSpotLight;

//material
uniform sampler2D texDiff;
uniform sampler2D texEmit;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 emissionColor;

//lights
uniform PointLight pointLights[NUM_POINT_LIGHTS];
uniform SpotLight spotLight;

//fragment shader output
out vec4 color;

float getAttenuation(float d, vec3 k) {
    return 1.0f / (k.x + k.y * d + k.z * pow(d, 2.0f));
}

float getSpotIntensity(vec3 lightDir) {
    float theta = dot(lightDir, normalize(-spotLight.direction));
    float inner = cos(spotLight.innerCone);
    float outer = cos(spotLight.outerCone);
    return clamp((theta - outer) / (inner - outer), 0.0f, 1.0f);
}

// Blinn-Phong
vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diffColor, vec3 specColor) {
    float diffuse = max(dot(n, l), 0.0f);
    vec3 halfVector = normalize(l + v);
    float specular = pow(max(dot(n, halfVector), 0.0f), shininess);
    return diffColor * diffuse + specColor * specular;
}

vec3 allPointLights(vec3 n, vec3 v, vec3 diffColor, vec3 specColor) {
    vec3 sum = vec3(0.0f);
    for (int i = 0; i < NUM_POINT_LIGHTS; i++) {
        vec3 l = normalize(toPointLight[i]);
        float att = getAttenuation(length(toPointLight[i]), pointLights[i].attenuation);
        sum += shade(n, l, v, diffColor, specColor) * pointLights[i].color * att;
    }
    return sum;
}

void main() {
    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);

    vec3 diffColor = texture(texDiff, vertexData.tc).rgb;
    vec3 emitColor = texture(texEmit, vertexData.tc).rgb;
    vec3 specColor = texture(texSpec, vertexData.tc).rgb;

    vec3 result = emitColor * emissionColor;
    result += allPointLights(n, v, diffColor, specColor);

    vec3 l = normalize(toSpotLight);
    float att = getAttenuation(length(toSpotLight), spotLight.attenuation);
    result += shade(n, l, v, diffColor, specColor) * spotLight.color * getSpotIntensity(l) * att;

    color = vec4(result, 1.0f);
}
