#version 330 core

//input from vertex shader
in struct VertexData
{
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
    vec3 toBikePoint;
    vec3 toBikeSpot;
    vec3 toRed;
    vec3 toBlue;
    vec3 toYellow;
    vec3 toViolet;
} vertexData;

//material
uniform sampler2D materialEmit;
uniform sampler2D materialDiff;
uniform sampler2D materialSpec;
uniform float materialShininess;
uniform vec3 shadingColor;

//lights
uniform vec3 bikePointLightColor;
uniform vec3 bikePointLightAtt;

uniform vec3 bikeSpotLightColor;
uniform vec3 bikeSpotLightAtt;
uniform vec2 bikeSpotLightAngle;
uniform vec3 bikeSpotLightDir;

uniform vec3 redCornerLightColor;
uniform vec3 redCornerLightAtt;
uniform vec3 blueCornerLightColor;
uniform vec3 blueCornerLightAtt;
uniform vec3 yellowCornerLightColor;
uniform vec3 yellowCornerLightAtt;
uniform vec3 violetCornerLightColor;
uniform vec3 violetCornerLightAtt;

//fragment shader output
out vec4 color;

vec3 gamma(vec3 C_linear)
{
    return pow(C_linear, vec3(1.0f / 2.2f));
}

vec3 invgamma(vec3 C_gamma)
{
    return pow(C_gamma, vec3(2.2f));
}

// Blinn-Phong (4.7), Phong with reflect() was here before
vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diff, vec3 spec, float shine)
{
    float cosa = max(0.0f, dot(n, l));
    vec3 diffuse = diff * cosa;

    vec3 halfway = normalize(l + v);
    float cosb = max(0.0f, dot(n, halfway));
    vec3 specular = spec * pow(cosb, shine);

    return diffuse + specular;
}

float attenuate(float len, vec3 attParam)
{
    return 1.0f / (attParam.x + attParam.y * len + attParam.z * len * len);
}

vec3 pointLightIntensity(vec3 lightcolor, float len, vec3 attParam)
{
    return lightcolor * attenuate(len, attParam);
}

vec3 spotLightIntensity(vec3 lightcolor, float len, vec3 attParam, vec3 l, vec3 spotDir, vec2 angle)
{
    float costheta = dot(-l, normalize(spotDir));
    float cosphi = cos(angle.y);
    float cosgamma = cos(angle.x);
    float intensity = clamp((costheta - cosphi) / (cosgamma - cosphi), 0.0f, 1.0f);
    return lightcolor * intensity * attenuate(len, attParam);
}

void main(){
    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);

    vec3 diffCol = invgamma(texture(materialDiff, vertexData.tc).rgb);
    vec3 emitCol = invgamma(texture(materialEmit, vertexData.tc).rgb);
    vec3 specCol = texture(materialSpec, vertexData.tc).rgb;

    //emissive
    vec3 result = emitCol * shadingColor;

    //bike point light
    vec3 lp = normalize(vertexData.toBikePoint);
    result += shade(n, lp, v, diffCol, specCol, materialShininess)
            * pointLightIntensity(bikePointLightColor, length(vertexData.toBikePoint), bikePointLightAtt);

    //bike spot light
    vec3 sp = normalize(vertexData.toBikeSpot);
    result += shade(n, sp, v, diffCol, specCol, materialShininess)
            * spotLightIntensity(bikeSpotLightColor, length(vertexData.toBikeSpot), bikeSpotLightAtt, sp, bikeSpotLightDir, bikeSpotLightAngle);

    //corners
    result += shade(n, normalize(vertexData.toRed), v, diffCol, specCol, materialShininess)
            * pointLightIntensity(redCornerLightColor, length(vertexData.toRed), redCornerLightAtt);
    result += shade(n, normalize(vertexData.toBlue), v, diffCol, specCol, materialShininess)
            * pointLightIntensity(blueCornerLightColor, length(vertexData.toBlue), blueCornerLightAtt);
    result += shade(n, normalize(vertexData.toYellow), v, diffCol, specCol, materialShininess)
            * pointLightIntensity(yellowCornerLightColor, length(vertexData.toYellow), yellowCornerLightAtt);
    result += shade(n, normalize(vertexData.toViolet), v, diffCol, specCol, materialShininess)
            * pointLightIntensity(violetCornerLightColor, length(vertexData.toViolet), violetCornerLightAtt);

    color = vec4(gamma(result), 1.0f);
}
