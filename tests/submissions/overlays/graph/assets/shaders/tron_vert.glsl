#version 330 core
layout(location = 0) in vec3 vertex;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec3 normal;

struct Matrices { mat4 modelView; mat4 projection; };
uniform Matrices matrices;
uniform vec2 repeat;

out vec2 fUv;
out vec3 fNormal;
out vec3 fPosition;

void main() {
    // the cofactors are the inverse transpose but for a factor
    mat3 m = mat3(matrices.modelView);
    fNormal = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])) * normal;
    fPosition = (matrices.modelView * vec4(vertex, 1)).xyz;
    fUv = uv * repeat;
    gl_Position = matrices.projection * vec4(fPosition, 1);
}
