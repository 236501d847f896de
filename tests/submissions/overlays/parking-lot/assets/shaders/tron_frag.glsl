#version 330 core
#define LIGHTS 8

struct PointLight {
    vec3 pos;
    vec3 col;
    vec3 att;
};

struct SpotLight {
    vec3 pos;
    vec3 col;
    vec3 att;
    vec3 dir;
    float inner;
    float outer;
};

in vec2 uv;
in vec3 normalVS;
in vec3 toCamera;
in vec3 toPoint[LIGHTS];
in vec3 toSpot;

uniform sampler2D matEmit;
uniform sampler2D matDiff;
uniform sampler2D matSpec;
uniform float matShininess;
uniform vec3 emitColor;

uniform PointLight pointLight[LIGHTS];
uniform SpotLight spotLight;

out vec4 color;

const vec3 ambient = vec3(0.03);

// Abschwaechung mit der Entfernung
float fade(vec3 k, float d) {
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// diffuser und spekularer Anteil (Blinn-Phong), alle Vektoren normalisiert
vec3 blinn(vec3 N, vec3 L, vec3 V, vec3 diff, vec3 spec) {
    vec3 H = normalize(L + V);
    float cosa = max(dot(N, L), 0.0);
    float cosb = max(dot(N, H), 0.0);
    return diff * cosa + spec * pow(cosb, matShininess);
}

// 1 im inneren Kegel, 0 ausserhalb des aeusseren
float cone(vec3 L) {
    float theta = dot(-L, normalize(spotLight.dir));
    float cosInner = cos(spotLight.inner);
    float cosOuter = cos(spotLight.outer);
    return clamp((theta - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
}

void main() {
    vec3 emit = texture(matEmit, uv).rgb;
    vec3 diff = texture(matDiff, uv).rgb;
    vec3 spec = texture(matSpec, uv).rgb;

    vec3 N = normalize(normalVS);
    vec3 V = normalize(toCamera);

    vec3 result = emit * emitColor + diff * ambient;

    for (int i = 0; i < LIGHTS; i++) {
        vec3 L = normalize(toPoint[i]);
        float d = length(toPoint[i]);
        vec3 lightCol = pointLight[i].col * fade(pointLight[i].att, d);
        result += blinn(N, L, V, diff, spec) * lightCol;
    }

    vec3 S = normalize(toSpot);
    vec3 spotCol = spotLight.col * cone(S) * fade(spotLight.att, length(toSpot));
    result += blinn(N, S, V, diff, spec) * spotCol;

    color = vec4(result, 1.0);
}
