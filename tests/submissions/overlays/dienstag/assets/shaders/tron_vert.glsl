#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texcoord;
layout(location = 2) in vec3 normal;

//uniforms
uniform mat4 model_matrix;
uniform mat4 normal_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;
uniform vec2 tcMultiplier;

uniform vec3 pointLight_pos;
uniform vec3 spotLight_pos;
uniform vec3 ecke1_pos;
uniform vec3 ecke2_pos;
uniform vec3 ecke3_pos;
uniform vec3 ecke4_pos;

out struct VertexData
{
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight;
    vec3 toSpotLight;
    vec3 toEcke1;
    vec3 toEcke2;
    vec3 toEcke3;
    vec3 toEcke4;
} vertexData;

vec3 inViewSpace(vec3 lightPos)
{
    return (view_matrix * vec4(lightPos, 1.0f)).xyz;
}

void main()
{
    vec4 worldPos = model_matrix * vec4(position, 1.0f);
    vec4 viewPos = view_matrix * worldPos;
    gl_Position = proj_matrix * viewPos;

    vertexData.tc = texcoord * tcMultiplier;
    vertexData.normal = mat3(view_matrix) * (normal_matrix * vec4(normal, 0.0f)).xyz;

    vertexData.toCamera = -viewPos.xyz;
    vertexData.toPointLight = inViewSpace(pointLight_pos) - viewPos.xyz;
    vertexData.toSpotLight = inViewSpace(spotLight_pos) - viewPos.xyz;
    vertexData.toEcke1 = inViewSpace(ecke1_pos) - viewPos.xyz;
    vertexData.toEcke2 = inViewSpace(ecke2_pos) - viewPos.xyz;
    vertexData.toEcke3 = inViewSpace(ecke3_pos) - viewPos.xyz;
    vertexData.toEcke4 = inViewSpace(ecke4_pos) - viewPos.xyz;
}
