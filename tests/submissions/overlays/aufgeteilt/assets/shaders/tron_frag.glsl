#version 330 core

// --- uniforms to set from Kotlin (for Tobi) ---
//   mat.diffuse_map, mat.specular_map, mat.emissive_map, mat.gloss, glow_color
//   point_lights[i].pos .color .falloff, num_points
//   spot_lights[i].light.pos .light.color .light.falloff, .dir .inner .outer, num_spots
// positions in world space, directions in view space, angles in radians

#define MAX_POINTS 8
#define MAX_SPOTS 4

struct Light {
    vec3 pos;
    vec3 color;
    vec3 falloff;
};

struct Spot {
    Light light;
    vec3 dir;
    float inner;
    float outer;
};

struct Mat {
    sampler2D diffuse_map;
    sampler2D specular_map;
    sampler2D emissive_map;
    float gloss;
};

in vec3 frag_pos;
in vec3 frag_norm;
in vec3 to_camera;
in vec2 frag_uv;

uniform mat4 view_matrix;
uniform Mat mat;
uniform vec3 glow_color;

uniform Light point_lights[MAX_POINTS];
uniform int num_points;
uniform Spot spot_lights[MAX_SPOTS];
uniform int num_spots;

out vec4 out_color;

const vec3 ambient = vec3(0.03);

vec3 to_light(Light light) {
    return vec3(view_matrix * vec4(light.pos, 1.0)) - frag_pos;
}

vec3 light_color(Light light) {
    float d = length(to_light(light));
    float f = light.falloff.x + light.falloff.y * d + light.falloff.z * pow(d, 2.0);
    return light.color / f;
}

// blinn-phong: diffuse and specular term of one light
vec3 shade(vec3 N, vec3 L, vec3 V, vec3 diff_color, vec3 spec_color) {
    float cosa = max(0.0, dot(N, L));
    vec3 H = normalize(L + V);
    float cosb = max(0.0, dot(N, H));
    return diff_color * cosa + spec_color * pow(cosb, mat.gloss);
}

float cone(Spot spot, vec3 L) {
    float theta = dot(normalize(spot.dir), -L);
    float gamma = cos(spot.inner);
    float phi = cos(spot.outer);
    return clamp((theta - phi) / (gamma - phi), 0.0, 1.0);
}

void main() {
    vec3 N = normalize(frag_norm);
    vec3 V = normalize(to_camera);
    vec3 diff_color = texture(mat.diffuse_map, frag_uv).rgb;
    vec3 spec_color = texture(mat.specular_map, frag_uv).rgb;
    vec3 emit_color = texture(mat.emissive_map, frag_uv).rgb;

    vec3 result = emit_color * glow_color + diff_color * ambient;

    for (int i = 0; i < num_points; ++i) {
        vec3 L = normalize(to_light(point_lights[i]));
        result += shade(N, L, V, diff_color, spec_color) * light_color(point_lights[i]);
    }

    for (int i = 0; i < num_spots; ++i) {
        vec3 L = normalize(to_light(spot_lights[i].light));
        result += shade(N, L, V, diff_color, spec_color) * light_color(spot_lights[i].light) * cone(spot_lights[i], L);
    }

    out_color = vec4(result, 1.0);
}
