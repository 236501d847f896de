#version 330 core

//lights
struct PointLight {
    vec3 pos;
    vec3 col;
    vec3 attParam;
};

struct SpotLight {
    vec3 pos;
    vec3 col;
    vec3 attParam;
    vec3 dir;
    vec2 cone;
};

//input from vertex shader
in vec3 viewPos;
in vec3 viewNormal;
in vec2 tc;

uniform mat4 view_matrix;

uniform PointLight bikeLight;
uniform SpotLight frontLight;
uniform PointLight cornerLight[4];

//material
uniform sampler2D mat_diff;
uniform sampler2D mat_spec;
uniform sampler2D mat_emit;
uniform float mat_shine;
uniform vec3 emitColor;

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

// from the fragment to a light, both in view space
vec3 toLight(vec3 lightPos)
{
    vec4 lp = view_matrix * vec4(lightPos, 1.0f);
    return lp.xyz - viewPos;
}

vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diff, vec3 spec, float shine)
{
    vec3 h = normalize(v + l);
    float cosa = max(0.0f, dot(n, l));
    float cosb = max(0.0f, dot(n, h));
    return diff * cosa + spec * pow(cosb, shine);
}

float attenuate(float len, vec3 attParam)
{
    return 1.0f / (attParam.x + attParam.y * len + attParam.z * len * len);
}

vec3 pointLightIntensity(vec3 lightcolour, float len, vec3 attParam)
{
    return lightcolour * attenuate(len, attParam);
}

vec3 spotLightIntensity(vec3 lightcolour, float len, vec3 attParam, vec3 sp, vec3 spDir, vec2 cone)
{
    float cosTheta = dot(sp, -normalize(spDir));
    float cosPhi = cos(cone.y);
    float cosGamma = cos(cone.x);
    float intensity = clamp((cosTheta - cosPhi) / (cosGamma - cosPhi), 0.0f, 1.0f);
    return lightcolour * intensity * attenuate(len, attParam);
}

void main()
{
    vec3 n = normalize(viewNormal);
    vec3 v = normalize(-viewPos);

    vec3 diff = invgamma(texture(mat_diff, tc).rgb);
    vec3 spec = invgamma(texture(mat_spec, tc).rgb);
    vec3 emit = invgamma(texture(mat_emit, tc).rgb);

    //emissive
    vec3 result = emit * emitColor;

    //point light of the bike
    vec3 lp = toLight(bikeLight.pos);
    float lpLen = length(lp);
    lp = normalize(lp);
    result += shade(n, lp, v, diff, spec, mat_shine) * pointLightIntensity(bikeLight.col, lpLen, bikeLight.attParam);

    //spot light
    vec3 sp = toLight(frontLight.pos);
    float spLen = length(sp);
    sp = normalize(sp);
    result += shade(n, sp, v, diff, spec, mat_shine) * spotLightIntensity(frontLight.col, spLen, frontLight.attParam, sp, frontLight.dir, frontLight.cone);

    //corner lights
    for (int i = 0; i < 4; i++)
    {
        vec3 cl = toLight(cornerLight[i].pos);
        float clLen = length(cl);
        cl = normalize(cl);
        result += shade(n, cl, v, diff, spec, mat_shine) * pointLightIntensity(cornerLight[i].col, clLen, cornerLight[i].attParam);
    }

    color = vec4(gamma(result), 1.0f);
}
