const int MAX_LIGHTS = 16;

// 64 bytes; see Light.kt
struct Light {
    vec3 position;
    float inner;
    vec3 color;
    float outer;
    vec3 direction;
    float isSpot;
    vec3 k;
};

// everything in view space
layout(std140) uniform Lights {
    Light lights[MAX_LIGHTS];
    int lightCount;
};
