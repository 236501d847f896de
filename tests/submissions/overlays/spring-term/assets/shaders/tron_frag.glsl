#version 330 core

in vec2 tc;
in vec3 n_view;
in vec3 toCamera;
in vec3 toLight[6];

uniform sampler2D diffTex;
uniform sampler2D emitTex;
uniform sampler2D specTex;
uniform float shine;
uniform vec3 glow;

uniform vec3 lightCol[6];
uniform vec3 spotDir;
uniform vec2 spotCos;   // inner, outer

out vec4 color;

void main() {
    // textures to linear
    vec3 Md = pow(texture(diffTex, tc).rgb, vec3(2.2));
    vec3 Me = pow(texture(emitTex, tc).rgb, vec3(2.2));
    vec3 Ms = texture(specTex, tc).rgb;

    vec3 n = normalize(n_view);
    vec3 v = normalize(toCamera);

    vec3 Lo = Me * glow;

    for (int i = 0; i < 6; i++) {
        vec3 l = normalize(toLight[i]);
        float d = length(toLight[i]);
        float att = 1.0 / (d * d);

        // the last one is the spot light
        float I = 1.0;
        if (i == 5) {
            float cosTheta = dot(normalize(spotDir), -l);
            I = clamp((cosTheta - spotCos.y) / (spotCos.x - spotCos.y), 0.0, 1.0);
        }

        float cosAlpha = max(dot(n, l), 0.0);
        vec3 h = normalize(l + v);
        float cosBeta = max(dot(n, h), 0.0);

        vec3 C = Md * cosAlpha;
        vec3 D = vec3(0.0);
        if (cosAlpha > 0.0) {
            D = Ms * pow(cosBeta, shine);
        }
        Lo += (C + D) * lightCol[i] * I * att;
    }

    // and back
    color = vec4(pow(Lo, vec3(1.0 / 2.2)), 1.0);
}
