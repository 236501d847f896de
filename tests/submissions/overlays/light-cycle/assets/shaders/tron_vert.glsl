#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

//uniforms
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;
uniform vec2 tcMultiplier;

uniform vec3 bikePointLightPos;
uniform vec3 bikeSpotLightPos;
uniform vec3 redCornerLightPos;
uniform vec3 blueCornerLightPos;
uniform vec3 yellowCornerLightPos;
uniform vec3 violetCornerLightPos;

out struct VertexData
{
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
    vec3 toBikePoint;
    vec3 toBikeSpot;
    vec3 toRed;
    vec3 toBlue;
    vec3 toYellow;
    vec3 toViolet;
} vertexData;

void main(){
    mat4 modelview = view_matrix * model_matrix;
    vec4 viewpos = modelview * vec4(position, 1.0f);
    mat4 normalMat = transpose(inverse(modelview));

    gl_Position = proj_matrix * viewpos;
    vertexData.tc = texCoord * tcMultiplier;
    vertexData.normal = (normalMat * vec4(normal, 0.0f)).xyz;

    // camera is at (0,0,0) in view space
    vertexData.toCamera = -viewpos.xyz;

    // vectors to the lights
    vec4 lp = view_matrix * vec4(bikePointLightPos, 1.0f);
    vertexData.toBikePoint = (lp - viewpos).xyz;
    lp = view_matrix * vec4(bikeSpotLightPos, 1.0f);
    vertexData.toBikeSpot = (lp - viewpos).xyz;
    lp = view_matrix * vec4(redCornerLightPos, 1.0f);
    vertexData.toRed = (lp - viewpos).xyz;
    lp = view_matrix * vec4(blueCornerLightPos, 1.0f);
    vertexData.toBlue = (lp - viewpos).xyz;
    lp = view_matrix * vec4(yellowCornerLightPos, 1.0f);
    vertexData.toYellow = (lp - viewpos).xyz;
    lp = view_matrix * vec4(violetCornerLightPos, 1.0f);
    vertexData.toViolet = (lp - viewpos).xyz;
}
