#version 330 core

#define ANZAHL 5

in struct VertexData {
    vec3 toCamera;
    vec2 texture_coordinate;
    vec3 normal;
} vertexData;

in vec3 toPointLight[ANZAHL];
in vec3 toSpotLight;

// Material
uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D specular;
uniform float shininess;
uniform vec3 sceneColor;

// Lichter
uniform vec3 ambientColor;
uniform vec3 pointLightColor[ANZAHL];
uniform vec3 pointLightAtt[ANZAHL];
uniform vec3 spotLightColor;
uniform vec3 spotLightAtt;
uniform vec3 spotLightDir;
uniform vec2 spotLightCone;

out vec4 color;

vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diffTex, vec3 specTex) {
    vec3 diffuse = diffTex * max(0.0, dot(n, l));
    // Blinn-Phong
    vec3 halfway = normalize(v + l);
    float cosBeta = max(0.0, dot(n, halfway));
    vec3 spec = specTex * pow(cosBeta, shininess);
    return diffuse + spec;
}

vec3 attenuate(vec3 lightColor, float d, vec3 att) {
    return lightColor / (att.x + att.y * d + att.z * pow(d, 2.0));
}

float cone(vec3 sp, vec3 dir) {
    float theta = dot(-sp, normalize(dir));
    float gamma = cos(spotLightCone.x);
    float phi = cos(spotLightCone.y);
    return clamp((theta - phi) / (gamma - phi), 0.0, 1.0);
}

void main() {
    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);
    vec3 diffTex = texture(diff, vertexData.texture_coordinate).rgb;
    vec3 emitTex = texture(emit, vertexData.texture_coordinate).rgb;
    vec3 specTex = texture(specular, vertexData.texture_coordinate).rgb;

    vec3 result = emitTex * sceneColor;
    result += diffTex * ambientColor;

    for (int i = 0; i < ANZAHL; i++) {
        float d = length(toPointLight[i]);
        vec3 lightColor = attenuate(pointLightColor[i], d, pointLightAtt[i]);
        result += shade(n, normalize(toPointLight[i]), v, diffTex, specTex) * lightColor;
    }

    vec3 sp = normalize(toSpotLight);
    vec3 lightColor = attenuate(spotLightColor, length(toSpotLight), spotLightAtt);
    float intensity = cone(sp, spotLightDir);
    result += shade(n, sp, v, diffTex, specTex) * lightColor * intensity;

    color = vec4(result, 1.0);
}
