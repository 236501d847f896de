#version 330 core

layout(location = 0) in vec3 in_pos;
layout(location = 1) in vec2 in_uv;
layout(location = 2) in vec3 in_norm;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;
uniform vec2 uv_scale;

// all of them in view space
out vec3 frag_pos;
out vec3 frag_norm;
out vec3 to_camera;
out vec2 frag_uv;

void main() {
    vec4 view_pos = view_matrix * model_matrix * vec4(in_pos, 1.0);
    mat3 normal_matrix = mat3(transpose(inverse(view_matrix * model_matrix)));

    frag_pos = view_pos.xyz;
    frag_norm = normal_matrix * in_norm;
    to_camera = -view_pos.xyz;
    frag_uv = in_uv * uv_scale;
    gl_Position = proj_matrix * view_pos;
}
