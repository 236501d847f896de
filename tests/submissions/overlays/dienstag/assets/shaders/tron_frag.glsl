#version 330 core

in struct VertexData
{
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight;
    vec3 toSpotLight;
    vec3 toEcke1;
    vec3 toEcke2;
    vec3 toEcke3;
    vec3 toEcke4;
} vertexData;

//Material
uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D spec;
uniform float shininess;
uniform vec3 emitColor;

//Lichter
uniform vec3 pointLight_color;
uniform vec3 pointLight_att;
uniform vec3 spotLight_color;
uniform vec3 spotLight_att;
uniform vec3 spotLight_dir;
uniform float spotLight_gamma;
uniform float spotLight_phi;
uniform vec3 ecke1_color;
uniform vec3 ecke1_att;
uniform vec3 ecke2_color;
uniform vec3 ecke2_att;
uniform vec3 ecke3_color;
uniform vec3 ecke3_att;
uniform vec3 ecke4_color;
uniform vec3 ecke4_att;

out vec4 color;

//Lichtabschwaechung
vec3 attenuate(vec3 lightColor, vec3 toLight, vec3 k)
{
    float d = length(toLight);
    float att = 1.0f / (k.x + k.y * d + k.z * d * d);
    return lightColor * att;
}

//C und D aus dem Phong-Modell, mit Halfvector
vec3 phong(vec3 N, vec3 L, vec3 V, vec3 diffTex, vec3 specTex)
{
    float cosa = max(0.0f, dot(N, L));
    vec3 H = normalize(L + V);
    float cosb = max(0.0f, dot(N, H));
    return diffTex * cosa + specTex * pow(cosb, shininess);
}

float spotIntensity(vec3 L)
{
    float cosTheta = dot(-L, spotLight_dir);
    float cosGamma = cos(spotLight_gamma);
    float cosPhi = cos(spotLight_phi);
    return clamp((cosTheta - cosPhi) / (cosGamma - cosPhi), 0.0f, 1.0f);
}

void main()
{
    vec3 diffTex = texture(diff, vertexData.tc).rgb;
    vec3 emitTex = texture(emit, vertexData.tc).rgb;
    vec3 specTex = texture(spec, vertexData.tc).rgb;

    vec3 N = normalize(vertexData.normal);
    vec3 V = normalize(vertexData.toCamera);

    //Emission
    vec3 result = emitTex * emitColor;

    //PointLight
    vec3 LP = normalize(vertexData.toPointLight);
    result += phong(N, LP, V, diffTex, specTex) * attenuate(pointLight_color, vertexData.toPointLight, pointLight_att);

    //SpotLight
    vec3 LS = normalize(vertexData.toSpotLight);
    float intensity = spotIntensity(LS);
    result += phong(N, LS, V, diffTex, specTex) * attenuate(spotLight_color, vertexData.toSpotLight, spotLight_att) * intensity;

    //Ecken
    vec3 L1 = normalize(vertexData.toEcke1);
    result += phong(N, L1, V, diffTex, specTex) * attenuate(ecke1_color, vertexData.toEcke1, ecke1_att);
    vec3 L2 = normalize(vertexData.toEcke2);
    result += phong(N, L2, V, diffTex, specTex) * attenuate(ecke2_color, vertexData.toEcke2, ecke2_att);
    vec3 L3 = normalize(vertexData.toEcke3);
    result += phong(N, L3, V, diffTex, specTex) * attenuate(ecke3_color, vertexData.toEcke3, ecke3_att);
    vec3 L4 = normalize(vertexData.toEcke4);
    result += phong(N, L4, V, diffTex, specTex) * attenuate(ecke4_color, vertexData.toEcke4, ecke4_att);

    color = vec4(result, 1.0f);
}
