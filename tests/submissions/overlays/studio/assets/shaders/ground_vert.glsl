#version 330 core
//#include camera.glsl

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec2 in_uv;
layout(location = 2) in vec3 in_normal;

uniform mat4 model;
uniform vec2 tiling;

out vec3 position;
out vec3 normal;
out vec2 uv;

void main() {
    vec4 p = view * model * vec4(in_position, 1.0);
    position = p.xyz;
    normal = mat3(view * model) * in_normal;
    uv = in_uv * tiling;
    gl_Position = projection * p;
}
