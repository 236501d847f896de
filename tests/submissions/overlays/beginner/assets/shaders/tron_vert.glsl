#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 textureCoords;
layout(location = 2) in vec3 normal;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;
uniform vec2 tcMultiplier;

uniform vec3 pointLightPos;
uniform vec3 pointLight2Pos;
uniform vec3 pointLight3Pos;
uniform vec3 pointLight4Pos;
uniform vec3 spotLightPos;

out struct VertexData
{
    vec3 position;
    vec2 textureCoords;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight;
    vec3 toPointLight2;
    vec3 toPointLight3;
    vec3 toPointLight4;
    vec3 toSpotLight;
} vertexData;

void main() {
    mat4 modelView = view_matrix * model_matrix;
    vec4 pos = modelView * vec4(position, 1.0f);
    vec4 norm = transpose(inverse(modelView)) * vec4(normal, 0.0f);

    gl_Position = proj_matrix * pos;

    vertexData.position = pos.xyz;
    vertexData.textureCoords = textureCoords * tcMultiplier;
    vertexData.normal = norm.xyz;

    //PointLight
    vec4 lp = view_matrix * vec4(pointLightPos, 1.0f);
    vertexData.toPointLight = (lp - pos).xyz;
    vec4 lp2 = view_matrix * vec4(pointLight2Pos, 1.0f);
    vertexData.toPointLight2 = (lp2 - pos).xyz;
    vec4 lp3 = view_matrix * vec4(pointLight3Pos, 1.0f);
    vertexData.toPointLight3 = (lp3 - pos).xyz;
    vec4 lp4 = view_matrix * vec4(pointLight4Pos, 1.0f);
    vertexData.toPointLight4 = (lp4 - pos).xyz;

    //SpotLight
    vec4 lps = view_matrix * vec4(spotLightPos, 1.0f);
    vertexData.toSpotLight = (lps - pos).xyz;

    vertexData.toCamera = -pos.xyz;
}
