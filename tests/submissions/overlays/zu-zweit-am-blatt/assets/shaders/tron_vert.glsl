#version 330 core

// keep in sync with the fragment shader
#define LAMP_COUNT 6

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec2 inUv;
layout(location = 2) in vec3 inNormal;

uniform mat4 toWorld;
uniform mat4 toView;
uniform mat4 toScreen;
uniform vec2 uvRepeat;

// lamp positions, already in view space (see LichtQuelle.kt)
uniform vec3 lampAt[LAMP_COUNT];

out vec2 uv;
out vec3 surfaceNormal;
out vec3 toEye;
out vec3 toLamp[LAMP_COUNT];

void main() {
    mat4 worldView = toView * toWorld;
    vec3 here = vec3(worldView * vec4(inPosition, 1.0));

    uv = inUv * uvRepeat;
    surfaceNormal = transpose(inverse(mat3(worldView))) * inNormal;
    toEye = -here;

    // do not normalize here, the fragment shader needs the length
    for (int i = 0; i < LAMP_COUNT; ++i) {
        toLamp[i] = lampAt[i] - here;
    }

    gl_Position = toScreen * vec4(here, 1.0);
}
