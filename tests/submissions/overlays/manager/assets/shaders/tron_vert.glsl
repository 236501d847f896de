#version 330 core

layout (location = 0) in vec3 a_Position;
layout (location = 1) in vec2 a_TexCoord;
layout (location = 2) in vec3 a_Normal;

uniform mat4 u_Model;
uniform mat4 u_ViewProjection;
uniform vec2 u_Repeat;

// everything in world coordinates
out VertexData {
    vec3 position;
    vec3 normal;
    vec2 texCoord;
} v_Out;

void main() {
    vec4 world = u_Model * vec4(a_Position, 1.0);
    v_Out.position = world.xyz;
    v_Out.normal = transpose(inverse(mat3(u_Model))) * a_Normal;
    v_Out.texCoord = a_TexCoord * u_Repeat;
    gl_Position = u_ViewProjection * world;
}
