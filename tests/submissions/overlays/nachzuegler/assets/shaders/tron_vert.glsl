#version 330 core

layout(location = 0) in vec3 pos;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec3 nor;

uniform mat4 mv;
uniform mat4 pm;
uniform vec2 tcm;

// alles schon view space
uniform vec3 plp;
uniform vec3 slp;
uniform vec3 e1p;
uniform vec3 e2p;
uniform vec3 e3p;
uniform vec3 e4p;

out vec2 u;
out vec3 no;
out vec3 tc;
out vec3 tl1;
out vec3 tl2;
out vec3 tl3;
out vec3 tl4;
out vec3 tl5;
out vec3 tl6;

void main() {
    vec3 q = (mv * vec4(pos, 1.0)).xyz;
    gl_Position = pm * vec4(q, 1.0);
    u = uv * tcm;
    //no = nor;
    no = inverse(transpose(mat3(mv))) * nor;

    tc = -q;
    tl1 = plp - q;
    tl2 = slp - q;
    tl3 = e1p - q;
    tl4 = e2p - q;
    tl5 = e3p - q;
    tl6 = e4p - q;
}
