#version 330 core

layout(location = 0) in vec3 pos;
layout(location = 1) in vec2 tex;
layout(location = 2) in vec3 nor;

uniform mat4 mm;
uniform mat4 vm;
uniform mat4 pm;
uniform vec2 tmul;

// licht am bike
uniform vec3 pospl;
// scheinwerfer
uniform vec3 possw;
// 4.6
uniform vec3 posl2;
uniform vec3 posl3;
uniform vec3 posl4;
uniform vec3 posl5;

out vec2 tc;
out vec3 nrm;
out vec3 zucam;
out vec3 zupl;
out vec3 zusw;
out vec3 zul2;
out vec3 zul3;
out vec3 zul4;
out vec3 zul5;

void main() {
    mat4 mv = vm * mm;
    vec4 p = mv * vec4(pos, 1.0);
    gl_Position = pm * p;

    tc = tex * tmul;
    // nrm = mat3(mv) * nor;
    nrm = transpose(inverse(mat3(mv))) * nor;

    zucam = -p.xyz;

    vec4 vpl = vm * vec4(pospl, 1.0);
    zupl = vpl.xyz - p.xyz;

    vec4 vsw = vm * vec4(possw, 1.0);
    zusw = vsw.xyz - p.xyz;

    vec4 vl2 = vm * vec4(posl2, 1.0);
    zul2 = vl2.xyz - p.xyz;

    vec4 vl3 = vm * vec4(posl3, 1.0);
    zul3 = vl3.xyz - p.xyz;

    vec4 vl4 = vm * vec4(posl4, 1.0);
    zul4 = vl4.xyz - p.xyz;

    vec4 vl5 = vm * vec4(posl5, 1.0);
    zul5 = vl5.xyz - p.xyz;
}
