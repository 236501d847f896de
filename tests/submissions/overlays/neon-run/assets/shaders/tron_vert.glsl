#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform mat4 moonMatrix;
uniform vec2 uvScale;

out VS_OUT {
    vec3 position;
    vec3 normal;
    vec2 uv;
    vec4 moonPosition;
} vs;

void main() {
    vec4 world = model * vec4(position, 1.0);
    vec4 viewSpace = view * world;
    vs.position = viewSpace.xyz;
    vs.normal = mat3(view) * transpose(inverse(mat3(model))) * normal;
    vs.uv = uv * uvScale;
    vs.moonPosition = moonMatrix * world;
    gl_Position = projection * viewSpace;
}
