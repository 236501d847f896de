#version 330 core
// Takes a vertex to the screen and hands the fragment shader the vectors of the lighting model, in view space.

// How many lights shine. The program puts the step's numbers here before compiling, so that a light that is off costs nothing.
const int LIGHTS = 10;

// solution 4.2.3: what the shader is told of a light, as in scene.frag
struct Light {
    vec3 position;     // view space
    vec3 color;
    vec3 attenuation;  // K_c, K_l, K_q
    vec3 direction;    // view space, unit length, away from the light; 0 for a point light
    vec2 cone;         // 1 - cos of the inner and of the outer angle; more than 2 for a point light: it shines everywhere
};
// end of solution

layout(location = 0) in vec3 position;  // model space
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;    // model space

uniform mat4 modelView;     // model space -> view space, composed on the CPU in double precision
uniform mat3 normalMatrix;  // the same for normals
uniform mat4 projection;    // view space -> clip space
uniform vec2 tcMultiplier;  // how often the textures repeat

// solution 4.2.3: the lights
uniform Light light[max(LIGHTS, 1)];
// end of solution

out vec2 surfaceTexCoord;                   // texture coordinates, multiplied
out vec3 normalView;                        // surface normal, any length
// solution 4.2.3: hand over the vectors to the camera and to the lights
// From the surface to the eye and to each light. They are affine in the position, so interpolating them is exact;
// normalising here would bend them between the vertices. Their lengths are the distances.
out vec3 toCameraView;
out vec3 toLightView[max(LIGHTS, 1)];
// end of solution

void main() {
    vec3 positionView = (modelView * vec4(position, 1.0)).xyz;

    surfaceTexCoord = texCoord * tcMultiplier;
    normalView = normalMatrix * normal;
    // solution 4.2.3: these vectors, in view space
    toCameraView = -positionView;
    for (int i = 0; i < LIGHTS; i++) toLightView[i] = light[i].position - positionView;
    // end of solution

    gl_Position = projection * vec4(positionView, 1.0);
}
