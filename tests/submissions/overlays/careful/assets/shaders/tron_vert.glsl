#version 330 core

// must be the same as in tron_frag.glsl and PointLight.MAX_POINT_LIGHTS
#define MAX_POINT_LIGHTS 8

// vertex attributes
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 textureCoordinate;
layout(location = 2) in vec3 normal;

// transformations
uniform mat4 modelMatrix;       // object space -> world space
uniform mat4 viewMatrix;        // world space  -> view space
uniform mat4 projectionMatrix;  // view space   -> clip space

// texture scaling
uniform vec2 tcMultiplier;

// lights: here only the positions (world space)
uniform vec3 pointLightPositions[MAX_POINT_LIGHTS];
uniform int numPointLights;
uniform vec3 spotLightPosition;

// everything in view space, normalized only in the fragment shader because interpolation changes the length
out vec2 fragTexCoord;
out vec3 fragNormal;
out vec3 toCamera;
out vec3 toPointLight[MAX_POINT_LIGHTS];
out vec3 toSpotLight;

// a point from world space to view space
vec3 pointToView(vec3 worldPoint) {
    return (viewMatrix * vec4(worldPoint, 1.0)).xyz;
}

// object space -> view space for normals; the inverse transpose keeps them perpendicular
vec3 normalToView(vec3 objectNormal) {
    mat3 normalMatrix = transpose(inverse(mat3(viewMatrix) * mat3(modelMatrix)));
    return normalMatrix * objectNormal;
}

void main() {
    vec4 worldPosition = modelMatrix * vec4(position, 1.0);
    vec3 viewPosition = pointToView(worldPosition.xyz);

    fragTexCoord = tcMultiplier * textureCoordinate;
    fragNormal = normalToView(normal);

    // the camera is the origin of view space: (0, 0, 0) - viewPosition
    toCamera = -viewPosition;
    for (int i = 0; i < numPointLights; i++) {
        toPointLight[i] = pointToView(pointLightPositions[i]) - viewPosition;
    }
    toSpotLight = pointToView(spotLightPosition) - viewPosition;

    gl_Position = projectionMatrix * vec4(viewPosition, 1.0);
}
