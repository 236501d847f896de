#version 330 core

in vec2 tc;
in vec3 normalView;
in vec3 toCamera;
in vec3 toLights[5];
in vec3 toSpot;

// material
uniform sampler2D texEmit;
uniform sampler2D texDiff;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 tint;

// lights
uniform vec3 lampColor[5];
uniform vec3 lampAtt[5];
uniform vec3 spotColor;
uniform vec3 spotAtt;
uniform vec3 spotDir;
uniform float spotInner;
uniform float spotOuter;

out vec4 color;

// the same for all lights, set in main
vec3 n;
vec3 v;
vec3 diff;
vec3 spec;

// fades a light with the distance
float attenuation(vec3 toLight, vec3 k) {
    float d = length(toLight);
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// 1 in the inner cone, 0 outside of the outer cone
float spotIntensity(vec3 l, vec3 direction, float inner, float outer) {
    float cosTheta = dot(-l, normalize(direction));
    float cosInner = cos(inner);
    float cosOuter = cos(outer);
    return clamp((cosTheta - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
}

// diffuse and specular part (Blinn-Phong) for one light
vec3 reflected(vec3 l, vec3 lightColor) {
    float cosAlpha = max(dot(n, l), 0.0);
    vec3 h = normalize(l + v);
    float cosBeta = max(dot(n, h), 0.0);
    return (diff * cosAlpha + spec * pow(cosBeta, shininess)) * lightColor;
}

vec3 pointLight(vec3 toLight, vec3 lightColor, vec3 k) {
    vec3 l = normalize(toLight);
    return reflected(l, lightColor * attenuation(toLight, k));
}

vec3 spotLight(vec3 toLight, vec3 lightColor, vec3 k, vec3 direction, float inner, float outer) {
    vec3 l = normalize(toLight);
    float intensity = spotIntensity(l, direction, inner, outer);
    return reflected(l, lightColor * intensity * attenuation(toLight, k));
}

void main() {
    vec3 emit = texture(texEmit, tc).rgb;
    diff = texture(texDiff, tc).rgb;
    spec = texture(texSpec, tc).rgb;
    n = normalize(normalView);
    v = normalize(toCamera);

    vec3 sum = emit * tint;
    for (int i = 0; i < 5; i++) sum += pointLight(toLights[i], lampColor[i], lampAtt[i]);
    sum += spotLight(toSpot, spotColor, spotAtt, spotDir, spotInner, spotOuter);
    color = vec4(sum, 1.0);
}
