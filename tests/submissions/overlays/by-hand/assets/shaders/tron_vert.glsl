#version 330 core
layout(location = 0) in vec3 a_pos;
layout(location = 1) in vec2 a_tc;
layout(location = 2) in vec3 a_nor;

uniform mat4 MV;
uniform mat4 P;
uniform mat3 NM;
uniform vec3 surface;

out vec3 pos;
out vec3 nor;
out vec2 tc;

void main() {
    pos = vec3(MV * vec4(a_pos, 1));
    nor = NM * a_nor;
    tc = a_tc * surface.xy;
    gl_Position = P * vec4(pos, 1);
}
