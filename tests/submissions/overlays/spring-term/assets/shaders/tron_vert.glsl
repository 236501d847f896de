#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 modelM;
uniform mat4 viewM;
uniform mat4 projM;
uniform vec2 tcMult;

// 0 motorcycle, 1 to 4 corners, 5 spot light
uniform vec3 lightPos[6];

out vec2 tc;
out vec3 n_view;
out vec3 toCamera;
out vec3 toLight[6];

void main() {
    vec4 p_world = modelM * vec4(position, 1.0);
    vec4 p_view = viewM * p_world;
    gl_Position = projM * p_view;

    tc = texCoord * tcMult;
    n_view = mat3(viewM) * mat3(modelM) * normal;   // only scaled evenly
    toCamera = -p_view.xyz;
    for (int i = 0; i < 6; i++) {
        toLight[i] = mat3(viewM) * (lightPos[i] - p_world.xyz);
    }
}
