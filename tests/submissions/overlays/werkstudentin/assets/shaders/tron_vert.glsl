#version 330 core

#define LAMP_COUNT 5

struct Lamp {
    vec3 position; // world space
    vec3 radiance;
};

struct Headlamp {
    vec3 position; // world space
    vec3 radiance;
    vec3 axis;     // view space
    vec2 cone;     // cosines of the inner and the outer angle
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 worldFromModel;
uniform mat4 viewFromWorld;
uniform mat4 clipFromView;
uniform vec2 uvScale;

uniform Lamp lamps[LAMP_COUNT];
uniform Headlamp headlamp;

// all vectors in view space, none of them normalized
out SurfacePoint {
    vec2 uv;
    vec3 normal;
    vec3 toEye;
    vec3 toLamp[LAMP_COUNT];
    vec3 toHeadlamp;
} point;

vec3 inView(vec3 world) {
    return (viewFromWorld * vec4(world, 1.0)).xyz;
}

void main() {
    vec3 world = (worldFromModel * vec4(position, 1.0)).xyz;
    vec3 view = inView(world);

    point.uv = texCoord * uvScale;
    point.normal = transpose(inverse(mat3(viewFromWorld * worldFromModel))) * normal;
    point.toEye = -view;
    for (int i = 0; i < LAMP_COUNT; i++) {
        point.toLamp[i] = inView(lamps[i].position) - view;
    }
    point.toHeadlamp = inView(headlamp.position) - view;

    gl_Position = clipFromView * vec4(view, 1.0);
}
