#version 330 core

in vec2 tc;
in vec3 fragNormal;
in vec3 toCamera;
in vec3 toPoint;
in vec3 toSpot;
in vec3 toCorner[4];

uniform sampler2D diffTex;
uniform sampler2D specTex;
uniform sampler2D emitTex;
uniform float shininess;
uniform vec3 emitColor;

uniform vec3 point_color;
uniform vec3 spot_color;
uniform vec3 spot_dir;
uniform float spot_cosInner;
uniform float spot_cosOuter;
uniform vec3 corner_color[4];

out vec4 color;

void main(){
    // gamma -> linear
    vec3 Md = pow(texture(diffTex, tc).rgb, vec3(2.2f));
    vec3 Me = pow(texture(emitTex, tc).rgb, vec3(2.2f));
    vec3 Ms = texture(specTex, tc).rgb;

    vec3 N = normalize(fragNormal);
    vec3 V = normalize(toCamera);

    // emission
    vec3 result = Me * emitColor;

    // ambient
    result += Md * 0.01f;

    // point light at the motorcycle
    vec3 L = normalize(toPoint);
    vec3 H = normalize(V + L);
    float d = length(toPoint);
    float cosa = max(0.0f, dot(N, L));
    float cosb = max(0.0f, dot(N, H));
    vec3 Li = point_color / (d * d);
    result += (Md * cosa + Ms * pow(cosb, shininess)) * Li;

    // headlight
    vec3 L2 = normalize(toSpot);
    vec3 H2 = normalize(V + L2);
    float d2 = length(toSpot);
    float cosa2 = max(0.0f, dot(N, L2));
    float cosb2 = max(0.0f, dot(N, H2));
    float cosTheta = dot(-L2, normalize(spot_dir));
    float I = clamp((cosTheta - spot_cosOuter) / (spot_cosInner - spot_cosOuter), 0.0f, 1.0f);
    vec3 Li2 = spot_color * I / (d2 * d2);
    result += (Md * cosa2 + Ms * pow(cosb2, shininess)) * Li2;

    // corners
    for (int i = 0; i < 4; i++) {
        vec3 L3 = normalize(toCorner[i]);
        vec3 H3 = normalize(V + L3);
        float d3 = length(toCorner[i]);
        float cosa3 = max(0.0f, dot(N, L3));
        float cosb3 = max(0.0f, dot(N, H3));
        vec3 Li3 = corner_color[i] / (d3 * d3);
        result += (Md * cosa3 + Ms * pow(cosb3, shininess)) * Li3;
    }

    // linear -> gamma
    color = vec4(pow(result, vec3(1.0f / 2.2f)), 1.0f);
}
