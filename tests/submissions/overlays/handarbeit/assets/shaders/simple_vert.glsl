#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 farbeIn;

out vec3 farbeVS;

// Blatt 1
void main(){
    gl_Position = vec4(position, 1.0f);
    farbeVS = farbeIn;
}
