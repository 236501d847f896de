#version 330 core

//input from vertex shader
in struct VertexData
{
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
    vec3 toBikeLight;
    vec3 toSpotLight;
    vec3 toEcke1;
    vec3 toEcke2;
    vec3 toEcke3;
    vec3 toEcke4;
} vertexData;

//Material
uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D specular;
uniform float shininess;
uniform vec3 farbe;

//Punktlicht am Bike
uniform vec3 bikeLightCol;
uniform vec3 bikeLightAttParam;

//Scheinwerfer
uniform vec3 spotLightCol;
uniform vec3 spotLightAttParam;
uniform vec2 spotLightAngle;
uniform vec3 spotLightDir;

//Ecken
uniform vec3 ecke1LightCol;
uniform vec3 ecke1LightAttParam;
uniform vec3 ecke2LightCol;
uniform vec3 ecke2LightAttParam;
uniform vec3 ecke3LightCol;
uniform vec3 ecke3LightAttParam;
uniform vec3 ecke4LightCol;
uniform vec3 ecke4LightAttParam;

//fragment shader output
out vec4 color;

vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diffCol, vec3 specCol, float shine) {
    float cosa = max(0.0, dot(n, l));
    vec3 diffuse = diffCol * cosa;
    // Phong (4.2)
    //vec3 r = reflect(-l, n);
    //float cosb = max(0.0, dot(r, v));
    // Blinn-Phong (4.7)
    vec3 halfway = normalize(l + v);
    float cosb = max(0.0, dot(n, halfway));
    vec3 spec = specCol * pow(cosb, shine);
    return diffuse + spec;
}

float attenuate(float len, vec3 attParam) {
    return 1.0 / (attParam.x + attParam.y * len + attParam.z * len * len);
}

vec3 pointLightIntensity(vec3 lightCol, float len, vec3 attParam) {
    return lightCol * attenuate(len, attParam);
}

vec3 spotLightIntensity(vec3 lightCol, float len, vec3 sp, vec3 spDir, vec3 attParam) {
    float cosTheta = dot(sp, normalize(spDir));
    float cosGamma = cos(spotLightAngle.x);
    float cosPhi = cos(spotLightAngle.y);
    float intensity = clamp((cosTheta - cosPhi) / (cosGamma - cosPhi), 0.0, 1.0);
    return lightCol * intensity * attenuate(len, attParam);
}

void main() {
    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);

    float bikeLen = length(vertexData.toBikeLight);
    vec3 lBike = vertexData.toBikeLight / bikeLen;
    float spotLen = length(vertexData.toSpotLight);
    vec3 lSpot = vertexData.toSpotLight / spotLen;

    vec3 diffCol = texture(diff, vertexData.tc).xyz;
    vec3 emitCol = texture(emit, vertexData.tc).xyz;
    vec3 specCol = texture(specular, vertexData.tc).xyz;

    // emissiv
    vec3 result = emitCol * farbe;

    // Punktlicht
    result += shade(n, lBike, v, diffCol, specCol, shininess) * pointLightIntensity(bikeLightCol, bikeLen, bikeLightAttParam);

    // Spotlight
    result += shade(n, lSpot, v, diffCol, specCol, shininess) * spotLightIntensity(spotLightCol, spotLen, -lSpot, spotLightDir, spotLightAttParam);

    // Ecken
    result += shade(n, normalize(vertexData.toEcke1), v, diffCol, specCol, shininess) * pointLightIntensity(ecke1LightCol, length(vertexData.toEcke1), ecke1LightAttParam);
    result += shade(n, normalize(vertexData.toEcke2), v, diffCol, specCol, shininess) * pointLightIntensity(ecke2LightCol, length(vertexData.toEcke2), ecke2LightAttParam);
    result += shade(n, normalize(vertexData.toEcke3), v, diffCol, specCol, shininess) * pointLightIntensity(ecke3LightCol, length(vertexData.toEcke3), ecke3LightAttParam);
    result += shade(n, normalize(vertexData.toEcke4), v, diffCol, specCol, shininess) * pointLightIntensity(ecke4LightCol, length(vertexData.toEcke4), ecke4LightAttParam);

    color = vec4(result, 1.0);
}
