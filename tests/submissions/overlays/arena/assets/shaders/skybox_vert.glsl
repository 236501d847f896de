#version 330 core

layout(location = 0) in vec3 position;

uniform mat4 view_matrix;
uniform mat4 projection_matrix;

out vec3 richtung;

void main() {
    richtung = position;
    vec4 pos = projection_matrix * mat4(mat3(view_matrix)) * vec4(position, 1.0);
    // z = w, also immer ganz hinten
    gl_Position = pos.xyww;
}
