#version 330 core
// The lighting model of the sheet, with everything in view space:
//   L_O = M_e·tint + M_d·L_a + Σ I·F·(M_d·max(cos α, 0) + M_s·max(cos β, 0)^k)·L

// How many lights shine. The program puts the step's numbers here before compiling, so that a light that is off costs nothing.
const int LIGHTS = 10;
// solution 4.2.3: what the shader is told of a light
// solution 4.3.3: and of its cone
const float MAX_FLOAT = 3.402823466e38;
const float TWO_TO_66 = 73786976294838206464.0;
// Where the formula's F is larger, a float could overflow on the way to the pixel.
const float MAX_ATTENUATION = 1e18;
// Of the sum of two opposite unit vectors nothing is left but their rounding, at most 16·2^-24; this is its square.
const float NO_HALF_VECTOR = 1e-12;

struct Light {
    vec3 position;     // view space
    vec3 color;
    vec3 attenuation;  // K_c, K_l, K_q
    vec3 direction;    // view space, unit length, away from the light; 0 for a point light
    vec2 cone;         // 1 - cos of the inner and of the outer angle; more than 2 for a point light: it shines everywhere
};
// end of solution

struct Material {
    sampler2D emissive;  // M_e
    sampler2D diffuse;   // M_d
    sampler2D specular;  // M_s
    float shininess;     // k
};

in vec2 surfaceTexCoord;   // texture coordinates, multiplied
// solution 4.2.3: take the vectors from the vertex shader
in vec3 normalView;        // surface normal, any length
in vec3 toCameraView;      // from the surface to the eye
in vec3 toLightView[max(LIGHTS, 1)];  // from the surface to each light; the length is the distance d
// end of solution

uniform Material material;
// solution 4.4: the colour of the object
uniform vec3 emissiveTint;
// end of solution
uniform vec3 ambient;       // L_a
// solution 4.7: half vector or reflected vector?
uniform bool blinnPhong;    // half vector instead of reflected vector
// end of solution
uniform float inverseGamma; // 1 for none

// solution 4.2.3: the lights
uniform Light light[max(LIGHTS, 1)];
// end of solution

out vec4 fragColor;

// solution 4.2.3: a function for the diffuse and the specular part, no angle beyond 90 degrees
// solution 4.3.3: one for the intensity I in the cone
// solution 4.3.4: one for the attenuation
// solution 4.7: the specular part with the half vector
// Where the vector is 0, so is every cosine with it: no light, instead of NaN. The same where its square is beyond a float.
vec3 normalizeOrZero(vec3 v) {
    float squared = dot(v, v);
    return squared > 0.0 && squared <= MAX_FLOAT ? v * inversesqrt(squared) : vec3(0.0);
}

// A normal whose square would overflow or vanish, brought nearer to 1 by a power of 2, which rounds nothing. The normal matrix of a model
// scaled by 1e-13 along one axis and by 1e13 along another makes normals as short as 1e-26.
vec3 inRange(vec3 normal) {
    float largest = max(max(abs(normal.x), abs(normal.y)), abs(normal.z));
    if (largest < 1e-15) return normal * TWO_TO_66;
    return largest > 1e15 ? normal / TWO_TO_66 : normal;
}

float clampedCosine(vec3 a, vec3 b) {
    return clamp(dot(a, b), 0.0, 1.0);
}

// F. A light at the surface itself has no direction and so no effect; one whose d² is beyond a float is too far to see.
float attenuationFactor(vec3 toLight, vec3 k) {
    float squared = dot(toLight, toLight);
    if (!(squared > 0.0 && squared <= MAX_FLOAT)) return 0.0;
    return 1.0 / max(k.x + k.y * sqrt(squared) + k.z * squared, 1.0 / MAX_ATTENUATION);
}

// I, linear in cos θ. Versines, 1 - cos θ = |l - s|²/2, keep what cosines of narrow cones round away.
float coneIntensity(vec3 fromLight, vec3 direction, vec2 cone) {
    vec3 chord = fromLight - direction;
    float versine = 0.5 * dot(chord, chord);
    float width = cone.y - cone.x;
    if (width > 0.0) return clamp((cone.y - versine) / width, 0.0, 1.0);
    return versine <= cone.y ? 1.0 : 0.0;
}

// max(cos β, 0)^k. pow(0, 0) is undefined in GLSL, so 0 is answered without asking.
float specularFactor(vec3 n, vec3 toLight, vec3 toCamera) {
    vec3 sum = toLight + toCamera;
    float cosine = blinnPhong
        ? (dot(sum, sum) > NO_HALF_VECTOR ? clampedCosine(n, normalizeOrZero(sum)) : 0.0)
        : clampedCosine(reflect(-toLight, n), toCamera);
    return cosine > 0.0 ? pow(cosine, material.shininess) : 0.0;
}

// The part of light of the given colour that the surface sends to the eye.
vec3 reflected(vec3 n, vec3 toLight, vec3 toCamera, vec3 diffuse, vec3 specular, vec3 lightColor) {
    // Where the interpolated normal is 0 no angle is defined; reflect() would answer the light's own direction.
    if (n == vec3(0.0)) return vec3(0.0);
    return (diffuse * clampedCosine(n, toLight) + specular * specularFactor(n, toLight, toCamera)) * lightColor;
}
// end of solution

void main() {
    vec3 emissive = texture(material.emissive, surfaceTexCoord).rgb;
    vec3 diffuse = texture(material.diffuse, surfaceTexCoord).rgb;
    // solution 4.2.3: the specular colour, and the vectors with length 1
    vec3 specular = texture(material.specular, surfaceTexCoord).rgb;
    vec3 n = normalizeOrZero(inRange(normalView));
    vec3 toCamera = normalizeOrZero(toCameraView);
    // end of solution

    // solution 4.4: emission in the colour of the object
    // instead: vec3 color = emissive + diffuse * ambient;
    vec3 color = emissive * emissiveTint + diffuse * ambient;
    // end of solution
    // solution 4.2.3: add the light of each point light
    // solution 4.3.3: add the light of each spotlight
    // solution 4.3.4: with their attenuation
    for (int i = 0; i < LIGHTS; i++) {
        vec3 toLight = normalizeOrZero(toLightView[i]);
        float f = attenuationFactor(toLightView[i], light[i].attenuation) * coneIntensity(-toLight, light[i].direction, light[i].cone);
        color += reflected(n, toLight, toCamera, diffuse, specular, f * light[i].color);
    }
    // end of solution
    fragColor = vec4(inverseGamma == 1.0 ? color : pow(max(color, 0.0), vec3(inverseGamma)), 1.0);
}
