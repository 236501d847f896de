#version 330 core
#define LAMPEN 5

layout(location = 0) in vec3 pos;
layout(location = 1) in vec2 tex;
layout(location = 2) in vec3 norm;

uniform mat4 modelMat;
uniform mat4 viewMat;
uniform mat4 projMat;
uniform vec2 kacheln;

//Lichter (Welt)
uniform vec3 posMotor;
uniform vec3 posFront;
uniform vec3 posLampe[LAMPEN];

out vec2 fTex;
out vec3 fNorm;
out vec3 fToCam;
out vec3 fToMotor;
out vec3 fToFront;
out vec3 fToLampe[LAMPEN];

void main(){
    //alles im Viewspace
    vec3 p = (viewMat * modelMat * vec4(pos, 1.0)).xyz;

    fTex = kacheln * tex;
    fNorm = inverse(transpose(mat3(viewMat * modelMat))) * norm;
    fToCam = -p;

    fToMotor = (viewMat * vec4(posMotor, 1.0)).xyz - p;
    fToFront = (viewMat * vec4(posFront, 1.0)).xyz - p;
    for(int i = 0; i < LAMPEN; i++){
        fToLampe[i] = (viewMat * vec4(posLampe[i], 1.0)).xyz - p;
    }

    gl_Position = projMat * vec4(p, 1.0);
}
