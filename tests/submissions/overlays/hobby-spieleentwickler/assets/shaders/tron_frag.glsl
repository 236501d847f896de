#version 330 core
#define MAX_LIGHTS 8

// same as in the vertex shader!
struct Light {
    vec3 pos;
    vec3 dir;
    vec3 color;
    vec3 k;     // constant, linear, quadratic
    vec2 cone;  // cos(inner), cos(outer)
};

struct Surface {
    sampler2D albedo;
    sampler2D gloss;
    sampler2D glow;
    float shine;
};

uniform Light lights[MAX_LIGHTS];
uniform int u_lightCount;
uniform Surface surf;
uniform vec3 u_glow;
uniform mat4 u_view;

in Varyings {
    vec2 uv;
    vec3 normal;
    vec3 toEye;
    vec3 toLight[MAX_LIGHTS];
} fs;

out vec4 o_color;

// 1 inside, 0 outside, a ramp in between (a point light is always inside)
float inCone(vec3 l, vec3 worldDir, vec2 cone) {
    vec3 axis = normalize(mat3(u_view) * worldDir);
    float cosTheta = dot(-l, axis);
    return clamp((cosTheta - cone.y) / (cone.x - cone.y), 0.0, 1.0);
}

float fade(float d, vec3 k) {
    return 1.0 / dot(k, vec3(1.0, d, d * d));
}

void main() {
    vec3 n = normalize(fs.normal);
    vec3 e = normalize(fs.toEye);

    vec3 albedo = texture(surf.albedo, fs.uv).rgb;
    vec3 gloss = texture(surf.gloss, fs.uv).rgb;

    vec3 lit = vec3(0.0);
    for (int i = 0; i < u_lightCount; i++) {
        float d = length(fs.toLight[i]);
        vec3 l = fs.toLight[i] / d;
        vec3 light = lights[i].color * inCone(l, lights[i].dir, lights[i].cone) * fade(d, lights[i].k);

        // Blinn-Phong
        vec3 h = normalize(l + e);
        float diffuse = max(dot(n, l), 0.0);
        float specular = pow(max(dot(n, h), 0.0), surf.shine);
        lit += (albedo * diffuse + gloss * specular) * light;
    }

    vec3 emission = texture(surf.glow, fs.uv).rgb * u_glow;
    o_color = vec4(emission + lit, 1.0);
}
