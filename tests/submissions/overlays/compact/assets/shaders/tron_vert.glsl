#version 330 core

layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec2 aTexCoord;
layout(location = 2) in vec3 aNormal;

uniform mat4 model, view, projection;
uniform vec2 tiling;

out vec3 P, N;
out vec2 uv;

void main() {
    mat4 toView = view * model;
    P = vec3(toView * vec4(aPosition, 1));
    // no inverse: nothing is scaled differently along the axes
    N = mat3(toView) * aNormal;
    uv = tiling * aTexCoord;
    gl_Position = projection * vec4(P, 1);
}
