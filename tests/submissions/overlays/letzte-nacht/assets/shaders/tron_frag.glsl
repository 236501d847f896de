#version 330 core

in vec2 tc;
in vec3 nor;
in vec3 toCam;
in vec3 toL1;
in vec3 toL2;
in vec3 spD;
in vec3 toL3;
in vec3 toL4;
in vec3 toL5;
in vec3 toL6;

uniform sampler2D tx1E;
uniform sampler2D tx2D;
uniform sampler2D tx3S;
uniform float sh;
uniform vec3 emC;

uniform vec3 lc1; // Motorrad
uniform vec3 lk1;
uniform vec3 lc2; // Spot
uniform vec3 lk2;
uniform float wi2;
uniform float wa2;
uniform vec3 lc3;
uniform vec3 lk3;
uniform vec3 lc4;
uniform vec3 lk4;
uniform vec3 lc5;
uniform vec3 lk5;
uniform vec3 lc6;
uniform vec3 lk6;

out vec4 color;

void main(){
    vec3 te = texture(tx1E, tc).rgb;
    vec3 td = texture(tx2D, tc).rgb;
    vec3 ts = texture(tx3S, tc).rgb;
    vec3 n = normalize(nor);
    vec3 v = normalize(toCam);

    vec3 l1 = normalize(toL1);
    vec3 l2 = normalize(toL2);
    vec3 l3 = normalize(toL3);
    vec3 l4 = normalize(toL4);
    vec3 l5 = normalize(toL5);
    vec3 l6 = normalize(toL6);

    // 4.3.4
    //float a1 = 1.0 / (length(toL1) * length(toL1)); // viel zu dunkel
    float a1 = 1.0 / (lk1.x + lk1.y * length(toL1) + lk1.z * length(toL1) * length(toL1));
    float a2 = 1.0 / (lk2.x + lk2.y * length(toL2) + lk2.z * length(toL2) * length(toL2));
    float a3 = 1.0 / (lk3.x + lk3.y * length(toL3) + lk3.z * length(toL3) * length(toL3));
    float a4 = 1.0 / (lk4.x + lk4.y * length(toL4) + lk4.z * length(toL4) * length(toL4));
    float a5 = 1.0 / (lk5.x + lk5.y * length(toL5) + lk5.z * length(toL5) * length(toL5));
    float a6 = 1.0 / (lk6.x + lk6.y * length(toL6) + lk6.z * length(toL6) * length(toL6));

    // Kegel vom Spot
    //float in2 = (ct2 - cos(wi2)) / (cos(wa2) - cos(wi2)); // geht nicht??
    float ct2 = dot(normalize(spD), -l2);
    float in2 = (ct2 - cos(wa2)) / (cos(wi2) - cos(wa2));
    in2 = clamp(in2, 0.0, 1.0);

    vec3 erg = te * emC;
    //vec3 erg = te;

    // diffus
    erg += td * max(dot(n, l1), 0.0) * lc1 * a1;
    erg += td * max(dot(n, l2), 0.0) * lc2 * a2 * in2;
    erg += td * max(dot(n, l3), 0.0) * lc3 * a3;
    erg += td * max(dot(n, l4), 0.0) * lc4 * a4;
    erg += td * max(dot(n, l5), 0.0) * lc5 * a5;
    erg += td * max(dot(n, l6), 0.0) * lc6 * a6;

    // spekular (4.7 mit Halfvector)
    //erg += ts * pow(max(dot(reflect(-l1, n), v), 0.0), sh) * lc1 * a1;
    //erg += ts * pow(max(dot(reflect(-l2, n), v), 0.0), sh) * lc2 * a2 * in2;
    erg += ts * pow(max(dot(n, normalize(l1 + v)), 0.0), sh) * lc1 * a1;
    erg += ts * pow(max(dot(n, normalize(l2 + v)), 0.0), sh) * lc2 * a2 * in2;
    erg += ts * pow(max(dot(n, normalize(l3 + v)), 0.0), sh) * lc3 * a3;
    erg += ts * pow(max(dot(n, normalize(l4 + v)), 0.0), sh) * lc4 * a4;
    erg += ts * pow(max(dot(n, normalize(l5 + v)), 0.0), sh) * lc5 * a5;
    erg += ts * pow(max(dot(n, normalize(l6 + v)), 0.0), sh) * lc6 * a6;

    //color = vec4(n, 1.0);
    color = vec4(erg, 1.0);
}
