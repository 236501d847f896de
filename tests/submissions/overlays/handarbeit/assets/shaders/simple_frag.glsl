#version 330 core

in vec3 farbeVS;
out vec4 color;

void main(){
    color = vec4(farbeVS, 1.0f);
}
