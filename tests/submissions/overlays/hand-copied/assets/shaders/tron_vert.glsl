#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texcoord;
layout(location = 2) in vec3 normal;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;
uniform vec2 tc_mul;
uniform vec3 light_pos;
uniform vec3 spot_pos;
uniform vec3 light2_pos;
uniform vec3 light3_pos;
uniform vec3 light4_pos;
uniform vec3 light5_pos;

out vec2 tc;
out vec3 norm;
out vec3 toCamera;
out vec3 toLight;
out vec3 toSpot;
out vec3 toLight2;
out vec3 toLight3;
out vec3 toLight4;
out vec3 toLight5;

void main() {
    vec4 pos = view_matrix * model_matrix * vec4(position, 1.0);
    gl_Position = proj_matrix * pos;
    tc = texcoord * tc_mul;
    norm = (transpose(inverse(view_matrix * model_matrix)) * vec4(normal, 0.0)).xyz;
    toCamera = -pos.xyz;

    vec4 lp = view_matrix * vec4(light_pos, 1.0);
    toLight = (lp - pos).xyz;

    vec4 sp = view_matrix * vec4(spot_pos, 1.0);
    toSpot = (sp - pos).xyz;

    vec4 lp2 = view_matrix * vec4(light2_pos, 1.0);
    toLight2 = (lp2 - pos).xyz;

    vec4 lp3 = view_matrix * vec4(light3_pos, 1.0);
    toLight3 = (lp3 - pos).xyz;

    vec4 lp4 = view_matrix * vec4(light4_pos, 1.0);
    toLight4 = (lp4 - pos).xyz;

    vec4 lp5 = view_matrix * vec4(light5_pos, 1.0);
    toLight5 = (lp5 - pos).xyz;
}
