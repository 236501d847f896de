#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texKoordinate;
layout(location = 2) in vec3 normale;

// Matrizen
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;

uniform vec2 tcMultiplier;

// Lichtpositionen (Weltkoordinaten)
uniform vec3 motorradLichtPos;
uniform vec3 scheinwerferPos;
uniform vec3 ecke1Pos;
uniform vec3 ecke2Pos;
uniform vec3 ecke3Pos;
uniform vec3 ecke4Pos;

out vec2 tc;
out vec3 normaleView;
out vec3 toCamera;
out vec3 toMotorradLicht;
out vec3 toScheinwerfer;
out vec3 toEcke1;
out vec3 toEcke2;
out vec3 toEcke3;
out vec3 toEcke4;

void main() {
    vec4 posWelt = model * vec4(position, 1.0);
    vec4 posView = view * posWelt;
    gl_Position = projection * posView;

    tc = texKoordinate * tcMultiplier;

    mat4 normalenMatrix = transpose(inverse(view * model));
    normaleView = (normalenMatrix * vec4(normale, 0.0)).xyz;

    // noch nicht normalisieren, erst im Fragment Shader
    toCamera = -posView.xyz;

    vec4 lichtView = view * vec4(motorradLichtPos, 1.0);
    toMotorradLicht = (lichtView - posView).xyz;

    vec4 spotView = view * vec4(scheinwerferPos, 1.0);
    toScheinwerfer = (spotView - posView).xyz;

    vec4 ecke1View = view * vec4(ecke1Pos, 1.0);
    toEcke1 = (ecke1View - posView).xyz;
    vec4 ecke2View = view * vec4(ecke2Pos, 1.0);
    toEcke2 = (ecke2View - posView).xyz;
    vec4 ecke3View = view * vec4(ecke3Pos, 1.0);
    toEcke3 = (ecke3View - posView).xyz;
    vec4 ecke4View = view * vec4(ecke4Pos, 1.0);
    toEcke4 = (ecke4View - posView).xyz;
}
