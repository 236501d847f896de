#version 330 core
#define POINT_LIGHTS 5
#define SPOT_LIGHTS 2

struct Material {
    sampler2D diff;
    sampler2D emit;
    sampler2D spec;
    float shininess;
};

struct PointLight {
    vec3 pos;
    vec3 color;
};

struct SpotLight {
    vec3 pos;
    vec3 color;
    vec3 dir;
    float cosInnen;
    float cosAussen;
};

in vec2 texcoord;
in vec3 normale;
in vec3 toCamera;
in vec3 toPointLight[POINT_LIGHTS];
in vec3 toSpotLight[SPOT_LIGHTS];

uniform Material material;
uniform vec3 farbe;
uniform PointLight pointLight[POINT_LIGHTS];
uniform SpotLight spotLight[SPOT_LIGHTS];

out vec4 color;

const float GAMMA = 2.2;

vec3 gamma(vec3 C_linear) {
    return pow(C_linear.rgb, vec3(1.0 / GAMMA));
}

vec3 invgamma(vec3 C_gamma) {
    return pow(C_gamma.rgb, vec3(GAMMA));
}

vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diff, vec3 spec, float shine) {
    float nl = max(dot(n, l), 0.0);
    if (nl <= 0.0) return vec3(0.0);
    vec3 h = normalize(v + l);
    float nh = max(dot(n, h), 0.0);
    return diff * nl + spec * pow(nh, shine);
}

float attenuate(float len) {
    return 1.0 / (len * len);
}

vec3 pointLightIntensity(vec3 lightColor, float len) {
    return lightColor * attenuate(len);
}

vec3 spotLightIntensity(SpotLight s, float len, vec3 l) {
    float cosTheta = dot(l, normalize(s.dir));
    float i = (cosTheta - s.cosAussen) / (s.cosInnen - s.cosAussen);
    return s.color * attenuate(len) * clamp(i, 0.0, 1.0);
}

void main() {
    vec3 n = normalize(normale);
    vec3 v = normalize(toCamera);

    vec3 diff = invgamma(texture(material.diff, texcoord).rgb);
    vec3 emit = invgamma(texture(material.emit, texcoord).rgb);
    vec3 spec = invgamma(texture(material.spec, texcoord).rgb);

    vec3 result = emit * farbe;
    result += diff * 0.01; // ambient

    for (int i = 0; i < POINT_LIGHTS; i++) {
        float len = length(toPointLight[i]);
        vec3 l = toPointLight[i] / len;
        result += shade(n, l, v, diff, spec, material.shininess) * pointLightIntensity(pointLight[i].color, len);
    }

    for (int i = 0; i < SPOT_LIGHTS; i++) {
        float len = length(toSpotLight[i]);
        vec3 l = toSpotLight[i] / len;
        result += shade(n, l, v, diff, spec, material.shininess) * spotLightIntensity(spotLight[i], len, l);
    }

    color = vec4(gamma(result), 1.0);
}
