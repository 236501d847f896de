#version 330 core
const int N = 7;

in vec2 uv;
in vec3 normal;
in vec3 toCamera;

uniform mat4 view;
uniform sampler2D mapKd, mapKs, mapKe;
uniform float k;
uniform vec3 glow;

uniform vec3 lightPos[N], lightColor[N], lightK[N], lightAxis[N];
uniform vec2 lightCone[N];

out vec4 fragment;

void main() {
    vec3 n = normalize(normal), v = normalize(toCamera);
    vec3 kd = texture(mapKd, uv).rgb, ks = texture(mapKs, uv).rgb, ke = texture(mapKe, uv).rgb;

    vec3 sum = ke * glow;
    for (int i = 0; i < N; ++i) {
        // light - p, and -p is toCamera
        vec3 toLight = (view * vec4(lightPos[i], 1.0)).xyz + toCamera;
        float d = length(toLight);
        vec3 l = toLight / d, h = normalize(l + v);

        float cone = clamp(dot(l, lightAxis[i]) * lightCone[i].x + lightCone[i].y, 0.0, 1.0);
        float fade = 1.0 / dot(lightK[i], vec3(1.0, d, d * d));
        vec3 radiance = lightColor[i] * cone * fade;

        sum += kd * radiance * max(dot(n, l), 0.0);
        sum += ks * radiance * pow(max(dot(n, h), 0.0), k);
    }
    fragment = vec4(sum, 1.0);
}
