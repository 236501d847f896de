#version 330 core
#define LIGHTS 6

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

in VertexData {
    vec2 texcoord;
    vec3 normal;
    vec3 toCamera;
    vec3 toSpot;
    vec3 toLight[LIGHTS];
} vertexData;

uniform PointLight pointLights[LIGHTS];

uniform vec3 spotColor;
uniform vec3 spotAttenuation;
uniform vec3 spotDirection;
uniform vec2 spotCone; // cos(innen), cos(außen)

uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D specular;
uniform float shininess;
uniform vec3 farbe;

out vec4 color;

float attenuate(float d, vec3 k) {
    return 1.0f / (k.x + k.y * d + k.z * d * d);
}

// C und D aus Aufgabe 4.1, Blinn-Phong
vec3 shade(vec3 n, vec3 l, vec3 v, vec3 md, vec3 ms) {
    vec3 h = normalize(l + v);
    float cosa = max(dot(n, l), 0.0f);
    float cosb = max(dot(n, h), 0.0f);
    return md * cosa + ms * pow(cosb, shininess);
}

float cone(vec3 l) {
    float theta = dot(normalize(spotDirection), -l);
    return clamp((theta - spotCone.y) / (spotCone.x - spotCone.y), 0.0f, 1.0f);
}

void main() {
    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);
    vec3 md = texture(diff, vertexData.texcoord).rgb;
    vec3 me = texture(emit, vertexData.texcoord).rgb;
    vec3 ms = texture(specular, vertexData.texcoord).rgb;

    vec3 result = me * farbe;
    for (int i = 0; i < LIGHTS; i++) {
        float d = length(vertexData.toLight[i]);
        vec3 l = vertexData.toLight[i] / d;
        vec3 li = pointLights[i].color * attenuate(d, pointLights[i].attenuation);
        result += shade(n, l, v, md, ms) * li;
    }

    float dist = length(vertexData.toSpot);
    vec3 ls = vertexData.toSpot / dist;
    vec3 spot = spotColor * attenuate(dist, spotAttenuation) * cone(ls);
    result += shade(n, ls, v, md, ms) * spot;

    color = vec4(result, 1.0f);
}
