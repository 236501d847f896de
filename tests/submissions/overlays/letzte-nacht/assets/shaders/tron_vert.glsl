#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

//uniform mat4 mM;
uniform mat4 mvM;
uniform mat4 vM;
uniform mat4 pM;
uniform mat4 nM;
uniform vec2 tcM;

uniform vec3 lp1; // Motorrad
uniform vec3 lp2; // Spot
uniform vec3 ld2;
uniform vec3 lp3;
uniform vec3 lp4;
uniform vec3 lp5;
uniform vec3 lp6;

out vec2 tc;
out vec3 nor;
out vec3 toCam;
out vec3 toL1;
out vec3 toL2;
out vec3 spD;
out vec3 toL3;
out vec3 toL4;
out vec3 toL5;
out vec3 toL6;

void main(){
    vec4 p = mvM * vec4(position, 1.0);
    gl_Position = pM * p;
    tc = texCoord * tcM;

    //nor = normal;
    //nor = mat3(mvM) * normal;
    nor = (nM * vec4(normal, 0.0)).xyz;

    toCam = -p.xyz;
    toL1 = (vM * vec4(lp1, 1.0)).xyz - p.xyz;
    toL2 = (vM * vec4(lp2, 1.0)).xyz - p.xyz;
    spD = (vM * vec4(ld2, 0.0)).xyz;
    toL3 = (vM * vec4(lp3, 1.0)).xyz - p.xyz;
    toL4 = (vM * vec4(lp4, 1.0)).xyz - p.xyz;
    toL5 = (vM * vec4(lp5, 1.0)).xyz - p.xyz;
    toL6 = (vM * vec4(lp6, 1.0)).xyz - p.xyz;
}
