// The factors of the lighting model, one function each.

// solution 4.7: half vector or reflected vector?
uniform bool blinnPhong;  // half vector instead of reflected vector
// end of solution

// solution 4.2.3: a function for the diffuse and the specular part, no angle beyond 90 degrees
// solution 4.3.3: one for the intensity I in the cone
// solution 4.3.4: one for the attenuation
// solution 4.7: the specular part with the half vector
const float MAX_FLOAT = 3.402823466e38;
const float TWO_TO_66 = 73786976294838206464.0;
// Where the formula's F is larger, a float could overflow on the way to the pixel.
const float MAX_ATTENUATION = 1e18;
// Of the sum of two opposite unit vectors nothing is left but their rounding, at most 16·2^-24; this is its square.
const float NO_HALF_VECTOR = 1e-12;

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

// max(cos α, 0).
float diffuseFactor(vec3 n, vec3 toLight) {
    return clamp(dot(n, toLight), 0.0, 1.0);
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

// h; 0 where light and eye are opposite each other.
vec3 halfVector(vec3 toLight, vec3 toCamera) {
    vec3 sum = toLight + toCamera;
    return dot(sum, sum) > NO_HALF_VECTOR ? normalizeOrZero(sum) : vec3(0.0);
}

// r; 0 where the normal is: reflect() would answer the light's own direction.
vec3 reflectedVector(vec3 n, vec3 toLight) {
    return n == vec3(0.0) ? n : reflect(-toLight, n);
}

// cos β, not clamped.
float specularCosine(vec3 n, vec3 toLight, vec3 toCamera) {
    return blinnPhong ? dot(n, halfVector(toLight, toCamera)) : dot(reflectedVector(n, toLight), toCamera);
}

// max(cos β, 0)^k. pow(0, 0) is undefined in GLSL, so 0 is answered without asking.
float specularFactor(vec3 n, vec3 toLight, vec3 toCamera) {
    float cosine = clamp(specularCosine(n, toLight, toCamera), 0.0, 1.0);
    return cosine > 0.0 ? pow(cosine, material.shininess) : 0.0;
}
// end of solution
