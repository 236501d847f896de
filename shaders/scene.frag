#version 330 core
// The lighting model of the sheet, with everything in view space:
//   L_O = M_e·tint + M_d·L_a + Σ I·F·(M_d·max(cos α, 0) + M_s·max(cos β, 0)^k)·L

#include "light.glsl"
#include "surface.glsl"
#include "lighting.glsl"

// solution 4.4: the colour of the object
uniform vec3 emissiveTint;
// end of solution
uniform vec3 ambient;       // L_a
uniform float inverseGamma; // 1 for none

out vec4 fragColor;

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
        vec3 reflected = diffuse * diffuseFactor(n, toLight) + specular * specularFactor(n, toLight, toCamera);
        color += reflected * (f * light[i].color);
    }
    // end of solution
    fragColor = vec4(inverseGamma == 1.0 ? color : pow(max(color, 0.0), vec3(inverseGamma)), 1.0);
}
