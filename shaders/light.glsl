// The lights of the scene: one list, whatever their kind.

// How many shine. The program puts the step's number here before compiling, so that a light that is off costs nothing.
const int LIGHTS = 10;

// solution 4.2.3: what the shaders are told of a light
// solution 4.3.3: and of its cone
struct Light {
    vec3 position;     // view space
    vec3 color;
    vec3 attenuation;  // K_c, K_l, K_q
    vec3 direction;    // view space, unit length, away from the light; 0 for a point light
    vec2 cone;         // 1 - cos of the inner and of the outer angle; more than 2 for a point light: it shines everywhere
};

uniform Light light[max(LIGHTS, 1)];
// end of solution
