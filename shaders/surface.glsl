// What a fragment shader is given of the surface.

#include "material.glsl"

in vec2 surfaceTexCoord;  // texture coordinates, multiplied
// solution 4.2.3: take the vectors from the vertex shader
in vec3 normalView;       // surface normal, any length
in vec3 toCameraView;     // from the surface to the eye
in vec3 toLightView[max(LIGHTS, 1)];  // from the surface to each light; the length is the distance d
// end of solution
