#version 330 core
#define ANZAHL_ECKEN 4

layout(location = 0) in vec3 in_pos;
layout(location = 1) in vec2 in_tc;
layout(location = 2) in vec3 in_normal;

// muss genauso im Fragment-Shader stehen!
struct Licht {
    bool istSpot;
    vec3 position;
    vec3 farbe;
    vec3 att;
    vec3 richtung;
    float gamma;
    float phi;
};

uniform mat4 u_model;
uniform mat4 u_view;
uniform mat4 u_proj;
uniform vec2 u_tcMultiplier;

uniform Licht u_bikeLight;
uniform Licht u_spotLight;
uniform Licht u_ecke[ANZAHL_ECKEN];

out vec2 v_tc;
out vec3 v_normal;
out vec3 v_toCamera;
out vec3 v_toBikeLight;
out vec3 v_toSpotLight;
out vec3 v_toEcke[ANZAHL_ECKEN];

void main(){
    mat4 mv = u_view * u_model;
    mat4 normalMat = transpose(inverse(mv));
    vec4 posView = mv * vec4(in_pos, 1.0f);

    gl_Position = u_proj * posView;
    v_tc = in_tc * u_tcMultiplier;
    v_normal = (normalMat * vec4(in_normal, 0.0f)).xyz;

    // Vektoren fuer die Beleuchtung (Viewspace), NICHT normalisieren
    v_toCamera = -posView.xyz;

    vec4 bikeLightView = u_view * vec4(u_bikeLight.position, 1.0f);
    v_toBikeLight = bikeLightView.xyz - posView.xyz;
    vec4 spotLightView = u_view * vec4(u_spotLight.position, 1.0f);
    v_toSpotLight = spotLightView.xyz - posView.xyz;

    for(int i = 0; i < ANZAHL_ECKEN; i++){
        vec4 eckeView = u_view * vec4(u_ecke[i].position, 1.0f);
        v_toEcke[i] = eckeView.xyz - posView.xyz;
    }
}
