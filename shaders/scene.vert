#version 330 core
// Takes a vertex to the screen and hands the fragment shader the vectors of the lighting model, in view space.

#include "light.glsl"

layout(location = 0) in vec3 position;  // model space
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;    // model space

uniform mat4 modelView;     // model space -> view space, composed on the CPU in double precision
uniform mat3 normalMatrix;  // the same for normals
uniform mat4 projection;    // view space -> clip space
uniform vec2 tcMultiplier;  // how often the textures repeat

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
