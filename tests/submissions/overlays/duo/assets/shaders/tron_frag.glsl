#version 330 core
#define ANZAHL_ECKEN 4

// input from vertex shader
in vec2 v_tc;
in vec3 v_normal;
in vec3 v_toCamera;
in vec3 v_toBikeLight;
in vec3 v_toSpotLight;
in vec3 v_toEcke[ANZAHL_ECKEN];

// material
uniform sampler2D u_diff;
uniform sampler2D u_spec;
uniform sampler2D u_emit;
uniform float u_shininess;
uniform vec3 u_farbe;

// Punktlicht und Spot in einem, istSpot sagt welches
struct Licht {
    bool istSpot;
    vec3 position;
    vec3 farbe;
    vec3 att;
    vec3 richtung;
    float gamma;
    float phi;
};

uniform Licht u_bikeLight;
uniform Licht u_spotLight;
uniform Licht u_ecke[ANZAHL_ECKEN];

//fragment shader output
out vec4 color;

// F_att = 1 / (Kc + Kl * d + Kq * d^2)
float abschwaechung(vec3 K, float d){
    return 1.0f / (K.x + K.y * d + K.z * d * d);
}

// Lichtkegel: innen 1, aussen 0, dazwischen linear
float kegel(Licht licht, vec3 L){
    float cosTheta = dot(-L, normalize(licht.richtung));
    float I = (cosTheta - cos(licht.phi)) / (cos(licht.gamma) - cos(licht.phi));
    return clamp(I, 0.0f, 1.0f);
}

// Blinn-Phong without the light color
vec3 shade(vec3 N, vec3 L, vec3 V, vec3 diffTex, vec3 specTex){
    vec3 diffuse = diffTex * max(0.0f, dot(N, L));
    vec3 halfDir = normalize(L + V);
    vec3 specular = specTex * pow(max(0.0f, dot(N, halfDir)), u_shininess);
    return diffuse + specular;
}

// Farbe, die vom Licht ankommt
vec3 lichtFarbe(Licht licht, vec3 toLight){
    float d = length(toLight);
    vec3 L = toLight / d;
    vec3 Li = licht.farbe * abschwaechung(licht.att, d);
    if(licht.istSpot){
        Li *= kegel(licht, L);
    }
    return Li;
}

void main(){
    vec3 N = normalize(v_normal);
    vec3 V = normalize(v_toCamera);
    vec3 diffTex = texture(u_diff, v_tc).rgb;
    vec3 specTex = texture(u_spec, v_tc).rgb;
    vec3 emitTex = texture(u_emit, v_tc).rgb;

    // emission
    vec3 result = emitTex * u_farbe;

    // bike light
    result += shade(N, normalize(v_toBikeLight), V, diffTex, specTex) * lichtFarbe(u_bikeLight, v_toBikeLight);
    // head light
    result += shade(N, normalize(v_toSpotLight), V, diffTex, specTex) * lichtFarbe(u_spotLight, v_toSpotLight);
    // Lichter in den Ecken
    for(int i = 0; i < ANZAHL_ECKEN; i++){
        result += shade(N, normalize(v_toEcke[i]), V, diffTex, specTex) * lichtFarbe(u_ecke[i], v_toEcke[i]);
    }

    color = vec4(result, 1.0f);
}
