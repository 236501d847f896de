#version 330 core
layout (location = 0) in vec3 aPos;
layout (location = 1) in vec2 aTexCoords;
layout (location = 2) in vec3 aNormal;

// everything that leaves this shader is in VIEW space (not world space like on the website!)
out vec3 FragPos;
out vec3 Normal;
out vec2 TexCoords;

uniform mat4 matModel;
uniform mat4 matView;
uniform mat4 matProj;
uniform vec2 texRepeat;

void main()
{
    mat4 modelView = matView * matModel;

    FragPos = vec3(modelView * vec4(aPos, 1.0));
    Normal = mat3(transpose(inverse(modelView))) * aNormal;
    TexCoords = texRepeat * aTexCoords;

    gl_Position = matProj * vec4(FragPos, 1.0);
}
