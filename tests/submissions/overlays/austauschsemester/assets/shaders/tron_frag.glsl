#version 330 core

#define NUM_LUCES 5
#define GAMMA 2.2

in vec3 vPos;
in vec3 vNormal;
in vec2 vTex;

struct Material {
    sampler2D diff;
    sampler2D spec;
    sampler2D emit;
    float brillo;
};

// like a dict of lists: luces.pos[i], luces.color[i]
// 0 = motorcycle, the others are the corners
struct Luces {
    vec3 pos[NUM_LUCES];
    vec3 color[NUM_LUCES];
};

struct Faro {
    vec3 pos;
    vec3 color;
    vec3 dir;
    float cosInner;
    float cosOuter;
};

uniform mat4 view;
uniform Material material;
uniform Luces luces;
uniform Faro faro;
uniform vec3 neon;

out vec4 fragColor;

vec3 toLinear(vec3 c) {
    return pow(c, vec3(GAMMA));
}

vec3 toScreen(vec3 c) {
    return pow(c, vec3(1.0 / GAMMA));
}

// from the fragment to a light, the position of the light comes in world space
vec3 wayTo(vec3 lightPos) {
    return (view * vec4(lightPos, 1.0)).xyz - vPos;
}

// inverse square law
float falloff(vec3 way) {
    float d = length(way);
    return 1.0 / (d * d);
}

// 1 inside, 0 outside, linear between the two cones
float cone(vec3 L) {
    float cosTheta = dot(normalize(faro.dir), -L);
    return clamp((cosTheta - faro.cosOuter) / (faro.cosInner - faro.cosOuter), 0.0, 1.0);
}

void main() {
    vec3 N = normalize(vNormal);
    vec3 V = normalize(-vPos);

    // collect the light first, the textures come at the end
    vec3 diffuse = vec3(0.02);   // ambient
    vec3 specular = vec3(0.0);

    // point lights
    for (int i = 0; i < NUM_LUCES; i++) {
        vec3 way = wayTo(luces.pos[i]);
        vec3 L = normalize(way);
        vec3 H = normalize(L + V);
        float cosA = max(dot(N, L), 0.0);
        float cosB = max(dot(N, H), 0.0);
        float att = falloff(way);

        diffuse += luces.color[i] * cosA * att;
        specular += luces.color[i] * pow(cosB, material.brillo) * att;
    }

    // faro
    vec3 farWay = wayTo(faro.pos);
    vec3 farL = normalize(farWay);
    vec3 farH = normalize(farL + V);
    float farA = max(dot(N, farL), 0.0);
    float farB = max(dot(N, farH), 0.0);
    float farAtt = falloff(farWay) * cone(farL);

    diffuse += faro.color * farA * farAtt;
    specular += faro.color * pow(farB, material.brillo) * farAtt;

    vec3 Md = toLinear(texture(material.diff, vTex).rgb);
    vec3 Ms = texture(material.spec, vTex).rgb;
    vec3 Me = toLinear(texture(material.emit, vTex).rgb);

    vec3 result = Me * neon;
    result += Md * diffuse + Ms * specular;
    fragColor = vec4(toScreen(result), 1.0);
}
