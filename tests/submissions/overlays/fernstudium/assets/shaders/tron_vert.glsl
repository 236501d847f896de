#version 330 core

layout(location = 0) in vec3 a_pos;
layout(location = 1) in vec2 a_tc;
layout(location = 2) in vec3 a_norm;

// Matrizen (alle auf der CPU fertig gerechnet, siehe Renderable.kt)
uniform mat4 u_modelView;
uniform mat4 u_normalMat;       // transponierte Inverse von u_modelView
uniform mat4 u_proj;

uniform vec2 u_tcScale;

// VS = Viewspace
out vec3 v_posVS;
out vec3 v_normVS;
out vec2 v_tc;

void main()
{
    vec4 posVS = u_modelView * vec4(a_pos, 1.0);

    v_posVS  = posVS.xyz;
    v_normVS = mat3(u_normalMat) * a_norm;      // normiert wird erst im FS, nach der Interpolation
    v_tc     = a_tc * u_tcScale;

    gl_Position = u_proj * posVS;
}
