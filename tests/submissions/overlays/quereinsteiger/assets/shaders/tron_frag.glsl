#version 330 core
// there is no half in GLSL, but my fingers do not know that
#define half2 vec2
#define half3 vec3
#define half4 vec4
#define MAX_ADD_LIGHTS 6

in Varyings {
    vec2 uv;
    vec3 normalVS;
    vec3 toCamera;
    vec3 toMainLight;
    vec3 toHeadLight;
    vec3 toAddLight[MAX_ADD_LIGHTS];
} fragIn;

// material
uniform sampler2D _MainTex;
uniform sampler2D _SpecGlossMap;
uniform sampler2D _EmissionMap;
uniform float _Gloss;
uniform half3 _EmissionColor;

// lights
uniform half3 _MainLightColor;
uniform half3 _MainLightFalloff;
uniform half3 _HeadLightColor;
uniform half3 _HeadLightFalloff;
uniform half3 _HeadLightDir;
uniform half2 _HeadLightCone; // cosine of inner, cosine of outer
uniform half3 _AddLightColor[MAX_ADD_LIGHTS];
uniform half3 _AddLightFalloff[MAX_ADD_LIGHTS];
uniform int _AddLightCount;

out half4 SV_Target;

struct SurfaceData {
    half3 albedo;
    half3 specular;
    half3 emission;
    half3 normal;
    half3 viewDir;
    float gloss;
};

float saturate(float x) {
    return clamp(x, 0.0, 1.0);
}

SurfaceData GetSurface() {
    SurfaceData s;
    s.albedo = texture(_MainTex, fragIn.uv).rgb;
    s.specular = texture(_SpecGlossMap, fragIn.uv).rgb;
    s.emission = texture(_EmissionMap, fragIn.uv).rgb * _EmissionColor;
    s.normal = normalize(fragIn.normalVS);
    s.viewDir = normalize(fragIn.toCamera);
    s.gloss = _Gloss;
    return s;
}

float Lambert(SurfaceData s, half3 toLight) {
    return saturate(dot(s.normal, normalize(toLight)));
}

float BlinnPhong(SurfaceData s, half3 toLight) {
    half3 halfDir = normalize(normalize(toLight) + s.viewDir);
    return pow(saturate(dot(s.normal, halfDir)), s.gloss);
}

float DistanceAtten(half3 toLight, half3 falloff) {
    float d = length(toLight);
    return 1.0 / (falloff.x + falloff.y * d + falloff.z * d * d);
}

float ConeAtten(half3 toLight) {
    float cosTheta = dot(-normalize(toLight), _HeadLightDir);
    return saturate((cosTheta - _HeadLightCone.y) / (_HeadLightCone.x - _HeadLightCone.y));
}

half3 ShadeMainLight(SurfaceData s) {
    float atten = DistanceAtten(fragIn.toMainLight, _MainLightFalloff);
    half3 diffuse = s.albedo * Lambert(s, fragIn.toMainLight);
    half3 specular = s.specular * BlinnPhong(s, fragIn.toMainLight);
    return (diffuse + specular) * atten * _MainLightColor;
}

half3 ShadeHeadLight(SurfaceData s) {
    float atten = DistanceAtten(fragIn.toHeadLight, _HeadLightFalloff);
    float cone = ConeAtten(fragIn.toHeadLight);
    half3 diffuse = s.albedo * Lambert(s, fragIn.toHeadLight);
    half3 specular = s.specular * BlinnPhong(s, fragIn.toHeadLight);
    return (diffuse + specular) * cone * atten * _HeadLightColor;
}

half3 ShadeAddLight(SurfaceData s, int i) {
    float atten = DistanceAtten(fragIn.toAddLight[i], _AddLightFalloff[i]);
    half3 diffuse = s.albedo * Lambert(s, fragIn.toAddLight[i]);
    half3 specular = s.specular * BlinnPhong(s, fragIn.toAddLight[i]);
    return (diffuse + specular) * atten * _AddLightColor[i];
}

void main() {
    SurfaceData s = GetSurface();

    half3 lit = ShadeMainLight(s) + ShadeHeadLight(s);
    for (int i = 0; i < _AddLightCount; i++) {
        lit += ShadeAddLight(s, i);
    }

    // half3 debug = s.normal * 0.5 + 0.5;
    SV_Target = half4(s.emission + lit, 1.0);
}
