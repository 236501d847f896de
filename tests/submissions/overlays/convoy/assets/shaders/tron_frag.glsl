#version 330 core
#define POINTS 8
#define SPOTS 2

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    PointLight base;
    vec3 direction;
    float innerCos;
    float outerCos;
};

in VertexData {
    vec2 uv;
    vec3 normal;
    vec3 toCamera;
    vec3 toPoint[POINTS];
    vec3 toSpot[SPOTS];
} fs;

uniform PointLight points[POINTS];
uniform SpotLight spots[SPOTS];

uniform sampler2D emitTex;
uniform sampler2D diffTex;
uniform sampler2D specTex;
uniform float shininess;
uniform vec3 glow;
uniform vec3 ambient;

out vec4 fragColor;

float fade(float d, vec3 k) {
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

vec3 blinnPhong(vec3 N, vec3 L, vec3 V, vec3 diff, vec3 spec) {
    float lambert = dot(N, L);
    if (lambert <= 0.0) return vec3(0.0);
    vec3 H = normalize(L + V);
    return diff * lambert + spec * pow(max(dot(N, H), 0.0), shininess);
}

void main() {
    vec3 diff = texture(diffTex, fs.uv).rgb;
    vec3 spec = texture(specTex, fs.uv).rgb;
    vec3 N = normalize(fs.normal);
    vec3 V = normalize(fs.toCamera);

    vec3 result = texture(emitTex, fs.uv).rgb * glow + diff * ambient;

    for (int i = 0; i < POINTS; i++) {
        vec3 L = normalize(fs.toPoint[i]);
        float f = fade(length(fs.toPoint[i]), points[i].attenuation);
        result += blinnPhong(N, L, V, diff, spec) * points[i].color * f;
    }

    for (int i = 0; i < SPOTS; i++) {
        vec3 L = normalize(fs.toSpot[i]);
        float f = fade(length(fs.toSpot[i]), spots[i].base.attenuation);
        float theta = dot(L, normalize(-spots[i].direction));
        float cone = clamp((theta - spots[i].outerCos) / (spots[i].innerCos - spots[i].outerCos), 0.0, 1.0);
        result += blinnPhong(N, L, V, diff, spec) * spots[i].base.color * cone * f;
    }

    fragColor = vec4(result, 1.0);
}
