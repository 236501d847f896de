#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model;       // model space -> world space
uniform mat4 view;        // world space -> view space
uniform mat4 projection;  // view space -> clip space
uniform vec2 tcMultiplier;

// solution 4.2.3: take the position of the point light; hand over the normal, toCamera and toLight, all in view space
// Lösung 4.2.3: Nehmen Sie die Position des Punktlichts entgegen; übergeben Sie Normale, toCamera und toLight, alle im Viewspace
// solution 4.3.3: the same for the spotlight: its position, and a toLight of its own
// Lösung 4.3.3: dasselbe für das Spotlight: seine Position und ein weiteres toLight
struct PointLight {
    vec3 position;  // world space
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    vec3 position;  // world space
    vec3 color;
    vec3 attenuation;
    vec3 direction;  // view space
    float innerAngle;
    float outerAngle;
};

uniform PointLight pointLight[5];
uniform SpotLight spotLight;
// end of solution

out vec2 tc;
// solution
out vec3 normalView;
out vec3 toCamera;
out vec3 toPointLight[5];
out vec3 toSpotLight;
// end of solution

void main() {
    vec4 positionView = view * model * vec4(position, 1.0);
    gl_Position = projection * positionView;
    tc = texCoord * tcMultiplier;
    // solution
    normalView = transpose(inverse(mat3(view * model))) * normal;
    toCamera = -positionView.xyz;
    for (int i = 0; i < 5; i++) {
        toPointLight[i] = (view * vec4(pointLight[i].position, 1.0)).xyz - positionView.xyz;
    }
    toSpotLight = (view * vec4(spotLight.position, 1.0)).xyz - positionView.xyz;
    // end of solution
}
