#version 330 core

#define MAX_LIGHTS 8

// point lights and spotlights: a point light has a cone of all directions
struct Light {
    vec3 place;
    vec3 axis;
    vec3 color;
    vec3 falloff;
    vec2 cone;
};

struct Maps {
    sampler2D diff, spec, emit;
    float shininess;
};

struct Sums {
    vec3 diffuse;
    vec3 specular;
};

in vec3 P, N;
in vec2 uv;

uniform Light lights[MAX_LIGHTS];
uniform int count;
uniform Maps map;
uniform vec3 glow;

out vec4 fragment;

// divides a vector into direction and length
void split(inout vec3 vector, out float len) {
    len = length(vector);
    vector /= len;
}

// what of the light is left at P, and where it comes from
void arrive(in Light light, out vec3 l, out vec3 left) {
    float d;
    l = light.place - P;
    split(l, d);
    float around = (dot(normalize(light.axis), l) - light.cone.y) / (light.cone.x - light.cone.y);
    left = light.color * clamp(around, 0, 1);
    left /= light.falloff.x + d * (light.falloff.y + d * light.falloff.z);
}

void gather(in vec3 n, in vec3 v, in Light light, inout Sums sums) {
    vec3 l, left;
    arrive(light, l, left);
    float lambert = dot(n, l);
    if (lambert <= 0) return;
    vec3 h = normalize(v + l);
    sums.diffuse += lambert * left;
    sums.specular += pow(max(dot(h, n), 0), map.shininess) * left;
}

void main() {
    vec3 n = normalize(N), v = normalize(-P);
    Sums sums = Sums(vec3(0), vec3(0));
    for (int i = 0; i < count; ++i) gather(n, v, lights[i], sums);

    fragment.rgb = glow * texture(map.emit, uv).rgb
        + sums.diffuse * texture(map.diff, uv).rgb
        + sums.specular * texture(map.spec, uv).rgb;
    fragment.a = 1;
}
