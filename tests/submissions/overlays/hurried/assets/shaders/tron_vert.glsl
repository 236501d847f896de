#version 330 core

layout(location = 0) in vec3 pos;
layout(location = 1) in vec2 texcoord;
layout(location = 2) in vec3 nor;

uniform mat4 m;
uniform mat4 v;
uniform mat4 p;
uniform vec2 tiles;

uniform vec3 lightPos;
uniform vec3 spotPos;
uniform vec3 spotDir;
uniform vec3 redPos;
uniform vec3 greenPos;
uniform vec3 bluePos;
uniform vec3 yellowPos;

out vec2 uv;
out vec3 nrm;
out vec3 toCam;
out vec3 toLight;
out vec3 toSpot;
out vec3 spotAxis;
out vec3 toRed;
out vec3 toGreen;
out vec3 toBlue;
out vec3 toYellow;

void main() {
    vec4 pv = v * m * vec4(pos, 1.0);
    gl_Position = p * pv;
    uv = texcoord * tiles;
    nrm = mat3(v * m) * nor;

    toCam = -pv.xyz;
    toLight = (v * vec4(lightPos, 1.0) - pv).xyz;
    toSpot = (v * vec4(spotPos, 1.0) - pv).xyz;
    spotAxis = mat3(v) * spotDir;
    toRed = (v * vec4(redPos, 1.0) - pv).xyz;
    toGreen = (v * vec4(greenPos, 1.0) - pv).xyz;
    toBlue = (v * vec4(bluePos, 1.0) - pv).xyz;
    toYellow = (v * vec4(yellowPos, 1.0) - pv).xyz;
}
