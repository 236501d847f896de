#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoords;
layout(location = 2) in vec3 normals;

//matrices
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;

uniform vec2 tcMultiplier;

// Lichter (Weltkoordinaten)
uniform vec3 pointLightPos;
uniform vec3 eckPos[4];

struct SpotLight {
    vec3 position;
    vec3 direction;
    vec3 color;
    float cutOff;
    float outerCutOff;
};
uniform SpotLight spotLight;

out vec2 tc;
out vec3 Normal;
out vec3 toCamera;
out vec3 toPointLight;
out vec3 toSpotLight;
out vec3 toEcke[4];

void main() {
    mat4 mv = view_matrix * model_matrix;
    vec4 viewPos = mv * vec4(position, 1.0f);

    tc = texCoords * tcMultiplier;
    Normal = (inverse(transpose(mv)) * vec4(normals, 0.0f)).xyz;

    toCamera = -viewPos.xyz;
    toPointLight = (view_matrix * vec4(pointLightPos, 1.0f) - viewPos).xyz;

    vec4 lp = view_matrix * vec4(spotLight.position, 1.0f);
    toSpotLight = (lp - viewPos).xyz;

    for (int i = 0; i < 4; i++) {
        vec4 ecke = view_matrix * vec4(eckPos[i], 1.0f);
        toEcke[i] = ecke.xyz - viewPos.xyz;
    }

    gl_Position = proj_matrix * viewPos;
}
