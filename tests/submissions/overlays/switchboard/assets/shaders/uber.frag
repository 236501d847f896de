#version 330 core

const int MAX_LAMPS = 8;

struct Lamp {
    int on;
    vec3 position;
    vec3 color;
    vec3 k;
};

struct Torch {
    int on;
    vec3 position;
    vec3 axis; // from the scene back into the torch
    vec3 color;
    vec3 k;
    float inner;
    float outer;
};

struct Sun {
    int on;
    vec3 toSun;
    vec3 color;
};

in vec3 vPos;
in vec3 vNormal;
in vec2 vUv;

// switches
uniform int uLit;
uniform int uToon;
uniform int uFog;

uniform sampler2D uDiffuse;
uniform sampler2D uEmissive;
uniform sampler2D uSpecular;
uniform float uShininess;
uniform vec3 uTint;

// all in view space
uniform Lamp uLamps[MAX_LAMPS];
uniform int uLampCount;
uniform Torch uTorch;
uniform Sun uSun;
uniform vec3 uUp;
uniform vec3 uAmbient;
uniform vec3 uSky;
uniform vec3 uSoil;
uniform vec2 uFogRange;

out vec4 fragColor;

vec3 N;
vec3 V;
vec3 Md;
vec3 Ms;

float steps(float x) {
    return uToon == 1 ? ceil(x * 4.0) / 4.0 : x;
}

vec3 blinn(vec3 L) {
    float lambert = max(dot(N, L), 0.0);
    if (lambert == 0.0) return vec3(0.0);
    vec3 H = normalize(L + V);
    float gloss = pow(max(dot(N, H), 0.0), uShininess);
    return Md * steps(lambert) + Ms * steps(gloss);
}

float falloff(float d, vec3 k) {
    return 1.0 / (k[0] + d * (k[1] + d * k[2]));
}

vec3 lampLight(Lamp lamp) {
    if (lamp.on == 0) return vec3(0.0);
    vec3 toLamp = lamp.position - vPos;
    return blinn(normalize(toLamp)) * lamp.color * falloff(length(toLamp), lamp.k);
}

vec3 torchLight(Torch torch) {
    if (torch.on == 0) return vec3(0.0);
    vec3 toTorch = torch.position - vPos;
    vec3 L = normalize(toTorch);
    float c = dot(L, normalize(torch.axis));
    float edge = cos(torch.outer);
    float intensity = clamp((c - edge) / (cos(torch.inner) - edge), 0.0, 1.0);
    return blinn(L) * torch.color * intensity * falloff(length(toTorch), torch.k);
}

vec3 sunLight() {
    return uSun.on == 1 ? blinn(normalize(uSun.toSun)) * uSun.color : vec3(0.0);
}

vec3 hemisphere() {
    return mix(uSoil, uSky, 0.5 + 0.5 * dot(N, uUp));
}

void main() {
    if (uLit == 0) {
        fragColor = vec4(uTint, 1.0);
        return;
    }

    N = normalize(vNormal);
    V = normalize(-vPos);
    Md = texture(uDiffuse, vUv).rgb;
    Ms = texture(uSpecular, vUv).rgb;
    vec3 Me = texture(uEmissive, vUv).rgb;

    vec3 sum = Me * uTint + Md * (uAmbient + hemisphere());
    for (int i = 0; i < uLampCount; i++) {
        sum += lampLight(uLamps[i]);
    }
    sum += torchLight(uTorch);
    sum += sunLight();

    if (uFog == 1) {
        float f = clamp((length(vPos) - uFogRange.x) / (uFogRange.y - uFogRange.x), 0.0, 1.0);
        sum = mix(sum, uSoil, f);
    }
    fragColor = vec4(sum, 1.0);
}
