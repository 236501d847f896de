#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

//uniforms
// translation object to world
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;
uniform vec2 tcMultiplier;

out vec3 viewPos;
out vec3 viewNormal;
out vec2 tc;

void main()
{
    mat4 modelview = view_matrix * model_matrix;
    vec4 pos = modelview * vec4(position, 1.0f);
    viewPos = pos.xyz;
    viewNormal = (inverse(transpose(modelview)) * vec4(normal, 0.0f)).xyz;
    tc = texCoord * tcMultiplier;
    gl_Position = proj_matrix * pos;
}
