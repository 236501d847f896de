#version 330 core

layout (location = 0) in vec3 aPos;
layout (location = 1) in vec2 aTexCoords;
layout (location = 2) in vec3 aNormal;

uniform mat4 modelView;
uniform mat4 projection;
uniform vec2 kacheln;

out vec3 fragPosView;
out vec3 normalView;
out vec2 texCoords;

void main()
{
    vec4 p = modelView * vec4(aPos, 1.0);
    fragPosView = vec3(p);
    normalView = transpose(inverse(mat3(modelView))) * aNormal;
    texCoords = aTexCoords * kacheln;
    gl_Position = projection * p;
}
