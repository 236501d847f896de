#version 330 core

#define MAX_POINT 8
#define MAX_SPOT 2

struct Material {
    sampler2D diffMap;
    sampler2D specMap;
    sampler2D emitMap;
    float shininess;
};

struct PointLamp {
    vec3 posView;
    vec3 color;
    vec3 att;       // constant, linear, quadratic
};

struct SpotLamp {
    vec3 posView;
    vec3 color;
    vec3 att;
    vec3 dirView;
    vec2 kegel;     // x = inner, y = outer (radians)
};

in vec3 fragPosView;
in vec3 normalView;
in vec2 texCoords;

uniform Material mat;
uniform vec3 emissionsFarbe;

// names from Scene.kt
uniform PointLamp punktlichter[MAX_POINT];
uniform int anzahlPunktlichter;
uniform SpotLamp strahler[MAX_SPOT];
uniform int anzahlStrahler;

out vec4 fragColor;

float attenuate(vec3 k, float dist)
{
    return 1.0 / (k.x + k.y * dist + k.z * dist * dist);
}

void main()
{
    const vec3 eye = vec3(0.0);             // view space!
    vec3 N = normalize(normalView);
    vec3 V = normalize(eye - fragPosView);

    vec3 diffuseSum = vec3(0.0);
    vec3 specularSum = vec3(0.0);

    // ---- point lights ----
    for (int i = 0; i < anzahlPunktlichter; i++) {
        vec3 L = punktlichter[i].posView - fragPosView;
        float dist = length(L);
        L = normalize(L);

        float NdotL = dot(N, L);
        if (NdotL <= 0.0) continue;         // behind the surface

        vec3 radiance = punktlichter[i].color * attenuate(punktlichter[i].att, dist);
        vec3 H = normalize(L + V);
        diffuseSum += radiance * NdotL;
        specularSum += radiance * pow(max(dot(N, H), 0.0), mat.shininess);
    }

    // ---- spot lights ----
    for (int s = 0; s < anzahlStrahler; s++) {
        vec3 toSpot = strahler[s].posView - fragPosView;
        float distSpot = length(toSpot);
        toSpot = normalize(toSpot);

        float NdotS = dot(N, toSpot);
        if (NdotS <= 0.0) continue;

        float theta = dot(-toSpot, normalize(strahler[s].dirView));
        float inner = cos(strahler[s].kegel.x);
        float outer = cos(strahler[s].kegel.y);
        float intensity = clamp((theta - outer) / (inner - outer), 0.0, 1.0);

        vec3 spotRadiance = strahler[s].color * intensity * attenuate(strahler[s].att, distSpot);
        vec3 halfSpot = normalize(toSpot + V);
        diffuseSum += spotRadiance * NdotS;
        specularSum += spotRadiance * pow(max(dot(N, halfSpot), 0.0), mat.shininess);
    }

    vec3 emission = texture(mat.emitMap, texCoords).rgb * emissionsFarbe;
    vec3 diffuse = texture(mat.diffMap, texCoords).rgb * diffuseSum;
    vec3 specular = texture(mat.specMap, texCoords).rgb * specularSum;

    fragColor = vec4(emission + diffuse + specular, 1.0);
}
