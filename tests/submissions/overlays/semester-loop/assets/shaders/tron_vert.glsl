#version 330 core

#define LIGHTS 6

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;
uniform vec3 lightPosition[LIGHTS];

out vec2 vTexCoord;
out vec3 vNormal;
out vec3 vToCamera;
out vec3 vToLight[LIGHTS];

void main() {
    mat4 modelview = view_matrix * model_matrix;
    vec4 viewpos = modelview * vec4(position, 1.0);

    vTexCoord = texCoord * tcMultiplier;
    vNormal = (transpose(inverse(modelview)) * vec4(normal, 0.0)).xyz;
    vToCamera = -viewpos.xyz;
    for (int i = 0; i < LIGHTS; i++) {
        vToLight[i] = (view_matrix * vec4(lightPosition[i], 1.0)).xyz - viewpos.xyz;
    }

    gl_Position = projection_matrix * viewpos;
}
