#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;

uniform vec3 point_pos;
uniform vec3 spot_pos;
uniform vec3 corner_pos[4];

out vec2 tc;
out vec3 fragNormal;
out vec3 toCamera;
out vec3 toPoint;
out vec3 toSpot;
out vec3 toCorner[4];

void main(){
    mat4 mv = view_matrix * model_matrix;
    vec4 p = mv * vec4(position, 1.0f);

    tc = texCoord * tcMultiplier;
    fragNormal = (inverse(transpose(mv)) * vec4(normal, 0.0f)).xyz;

    // everything in view space
    toCamera = -p.xyz;
    toPoint = (view_matrix * vec4(point_pos, 1.0f)).xyz - p.xyz;
    toSpot = (view_matrix * vec4(spot_pos, 1.0f)).xyz - p.xyz;
    for (int i = 0; i < 4; i++)
        toCorner[i] = (view_matrix * vec4(corner_pos[i], 1.0f)).xyz - p.xyz;

    gl_Position = projection_matrix * p;
}
