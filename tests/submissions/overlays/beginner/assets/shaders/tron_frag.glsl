#version 330 core

in struct VertexData
{
    vec3 position;
    vec2 textureCoords;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight;
    vec3 toPointLight2;
    vec3 toPointLight3;
    vec3 toPointLight4;
    vec3 toSpotLight;
} vertexData;

uniform sampler2D texEmit;
uniform sampler2D texDiff;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 objectColor;

uniform vec3 pointLightColor;
uniform vec3 pointLightAttParam;
uniform vec3 pointLight2Color;
uniform vec3 pointLight2AttParam;
uniform vec3 pointLight3Color;
uniform vec3 pointLight3AttParam;
uniform vec3 pointLight4Color;
uniform vec3 pointLight4AttParam;

uniform vec3 spotLightColor;
uniform vec3 spotLightAttParam;
uniform vec3 spotLightDir;
uniform vec2 spotLightAngle;

out vec4 color;

vec3 shade(vec3 matDiff, vec3 matSpec, vec3 n, vec3 l, vec3 v, float shiny)
{
    //diffuse
    float cosa = max(0.0f, dot(n, l));
    vec3 diffuse = matDiff * cosa;
    //specular, blinn
    vec3 halfway = normalize(l + v);
    float cosb = max(0.0f, dot(n, halfway));
    vec3 specular = matSpec * pow(cosb, shiny);
    return diffuse + specular;
}

float getAttenuation(float dist, vec3 param)
{
    return 1.0f / (param.x + param.y * dist + param.z * (dist * dist));
}

float getIntensity(vec3 sp, vec3 dir)
{
    float cosTheta = dot(-sp, dir);
    float cosGamma = cos(spotLightAngle.x);
    float cosPhi = cos(spotLightAngle.y);
    float intensity = (cosTheta - cosPhi) / (cosGamma - cosPhi);
    return clamp(intensity, 0.0f, 1.0f);
}

void main() {
    //normalize everything
    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);
    vec3 lp = normalize(vertexData.toPointLight);
    vec3 lp2 = normalize(vertexData.toPointLight2);
    vec3 lp3 = normalize(vertexData.toPointLight3);
    vec3 lp4 = normalize(vertexData.toPointLight4);
    vec3 sp = normalize(vertexData.toSpotLight);
    vec3 dir = normalize(spotLightDir);

    //lengths
    float lpLength = length(vertexData.toPointLight);
    float lp2Length = length(vertexData.toPointLight2);
    float lp3Length = length(vertexData.toPointLight3);
    float lp4Length = length(vertexData.toPointLight4);
    float spLength = length(vertexData.toSpotLight);

    //texture colors
    vec3 diffCol = texture(texDiff, vertexData.textureCoords).xyz;
    vec3 emitCol = texture(texEmit, vertexData.textureCoords).xyz;
    vec3 specCol = texture(texSpec, vertexData.textureCoords).xyz;

    //emissive
    vec3 result = emitCol * objectColor;

    //pointlights
    result += shade(diffCol, specCol, n, lp, v, shininess) * pointLightColor * getAttenuation(lpLength, pointLightAttParam);
    result += shade(diffCol, specCol, n, lp2, v, shininess) * pointLight2Color * getAttenuation(lp2Length, pointLight2AttParam);
    result += shade(diffCol, specCol, n, lp3, v, shininess) * pointLight3Color * getAttenuation(lp3Length, pointLight3AttParam);
    result += shade(diffCol, specCol, n, lp4, v, shininess) * pointLight4Color * getAttenuation(lp4Length, pointLight4AttParam);

    //spotlight
    result += shade(diffCol, specCol, n, sp, v, shininess) * spotLightColor * getIntensity(sp, dir) * getAttenuation(spLength, spotLightAttParam);

    color = vec4(result, 1.0f);
}
