#version 330 core

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec2 inTexCoord;
layout(location = 2) in vec3 inNormal;

// Blatt 2
uniform mat4 modelMat;
uniform mat4 viewMat;
uniform mat4 projMat;
// Blatt 3
uniform vec2 kacheln;
// Blatt 4: 0 = Motorrad, 1 bis 4 = Ecken (Welt)
uniform vec3 lichtPosition[5];
// kommt schon im Viewspace an
uniform vec3 spotPosition;

out vec2 texKoord;
out vec3 normale;
out vec3 zurKamera;
out vec3 zumLicht[5];
out vec3 zumSpot;

void main() {
    mat4 modelView = viewMat * modelMat;
    vec3 p = vec3(modelView * vec4(inPosition, 1.0));
    gl_Position = projMat * vec4(p, 1.0);

    texKoord = inTexCoord * kacheln;

    // alt: normale = mat3(modelView) * inNormal;
    normale = transpose(inverse(mat3(modelView))) * inNormal;

    // 4.2, erst im Fragmentshader normalisieren!
    zurKamera = -p;
    for (int i = 0; i < 5; i++) {
        zumLicht[i] = vec3(viewMat * vec4(lichtPosition[i], 1.0)) - p;
    }
    // 4.3
    zumSpot = spotPosition - p;
}
