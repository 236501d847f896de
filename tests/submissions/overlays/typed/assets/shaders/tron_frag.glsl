#version 330 core

const int MAX_LIGHTS = 16;
const int POINT = 0;
const int SPOT = 1;

struct Light {
    int type;
    vec3 position;
    vec3 direction;
    vec3 color;
    vec3 k;
    vec2 cone;
};

struct Surface {
    vec3 position;
    vec3 normal;
    vec3 toEye;
    vec3 diffuse;
    vec3 specular;
    float shininess;
};

in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;

uniform mat4 u_view;
uniform sampler2D u_diffuse;
uniform sampler2D u_emissive;
uniform sampler2D u_specular;
uniform float u_shininess;
uniform vec3 u_emission;
uniform int u_lightCount;
uniform Light u_lights[MAX_LIGHTS];

layout(location = 0) out vec4 out_color;

float falloff(Light light, vec3 l) {
    float d = length(l);
    float factor = 1.0 / dot(light.k, vec3(1.0, d, d * d));
    if (light.type == POINT) return factor;
    vec3 axis = normalize((u_view * vec4(light.direction, 0.0)).xyz);
    float c = dot(axis, -l / d);
    float inner = cos(light.cone.x);
    float outer = cos(light.cone.y);
    if (c >= inner) return factor;
    if (c <= outer) return 0.0;
    return factor * (c - outer) / (inner - outer);
}

vec3 shade(Light light, Surface s) {
    vec3 l = (u_view * vec4(light.position, 1.0)).xyz - s.position;
    float strength = falloff(light, l);
    if (strength == 0.0) return vec3(0.0);

    l = normalize(l);
    float lambert = max(dot(s.normal, l), 0.0);
    vec3 h = normalize(l + s.toEye);
    float gloss = pow(max(dot(s.normal, h), 0.0), s.shininess);
    return (s.diffuse * lambert + s.specular * gloss) * light.color * strength;
}

void main() {
    Surface s = Surface(
        v_position,
        normalize(v_normal),
        normalize(-v_position),
        texture(u_diffuse, v_uv).rgb,
        texture(u_specular, v_uv).rgb,
        u_shininess
    );
    vec3 sum = vec3(0.0);
    for (int i = 0; i < u_lightCount; i++) sum += shade(u_lights[i], s);
    out_color = vec4(sum + u_emission * texture(u_emissive, v_uv).rgb, 1.0);
}
