#version 330 core

layout(location = 0) in vec3 aPos;
layout(location = 1) in vec2 aTc;
layout(location = 2) in vec3 aNormal;

uniform mat4 uModel;
uniform mat4 uView;
uniform mat4 uProj;
uniform vec2 uTcMult;

// alles im Viewspace, normalisiert wird erst im Fragment-Shader
out vec3 vP;
out vec3 vN;
out vec2 vTc;

void main() {
    // VL: P_view = V * M * P
    mat4 MV = uView * uModel;
    vec4 P = MV * vec4(aPos, 1.0);

    // VL: Normalen werden mit der inversen Transponierten transformiert
    mat4 normalMat = transpose(inverse(MV));
    vec4 N = normalMat * vec4(aNormal, 0.0);

    vP = P.xyz;
    vN = N.xyz;
    vTc = aTc * uTcMult;

    gl_Position = uProj * P;
}
