#version 330 core
#define N 5      // 4 point lights and the spot light behind them

in vec3 pos;
in vec3 nor;
in vec2 tc;

uniform sampler2D maps[3];      // diffuse, specular, emission
uniform vec3 surface;           // tiling, shininess
uniform vec3 glow;
uniform vec3 lights[3 * N];     // position, colour, attenuation, position, ...
uniform float cone[5];          // direction, cos inner, cos outer

out vec4 rgba;

void main() {
    vec3 md = texture(maps[0], tc).rgb;
    vec3 ms = texture(maps[1], tc).rgb;
    vec3 me = texture(maps[2], tc).rgb;
    vec3 n = normalize(nor);
    vec3 v = normalize(-pos);

    vec3 c = me * glow;
    for (int i = 0; i < N; i++) {
        vec3 toLight = lights[3 * i] - pos;
        float d = length(toLight);
        vec3 l = toLight / d;
        vec3 k = lights[3 * i + 2];
        float f = 1 / (k.x + k.y * d + k.z * d * d);
        if (i == N - 1) {
            float theta = -dot(l, vec3(cone[0], cone[1], cone[2]));
            f *= clamp((theta - cone[4]) / (cone[3] - cone[4]), 0, 1);
        }
        vec3 h = normalize(l + v);
        vec3 phong = md * max(dot(n, l), 0) + ms * pow(max(dot(n, h), 0), surface.z);
        c += phong * lights[3 * i + 1] * f;
    }
    rgba = vec4(c, 1);
}
