#version 330 core

in vec2 tc;
// solution
in vec3 normalView;
in vec3 toCamera;
in vec3 toPointLight[5];
in vec3 toSpotLight;
// end of solution

uniform sampler2D texEmit;  // M_e
uniform sampler2D texDiff;  // M_d
uniform sampler2D texSpec;  // M_s
uniform float shininess;    // k

// solution
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
uniform vec3 tint;
// end of solution

out vec4 color;

// solution
vec3 reflected(vec3 toLight, vec3 lightColor) {
    vec3 n = normalize(normalView);
    vec3 l = normalize(toLight);
    vec3 h = normalize(l + normalize(toCamera));
    float cosAlpha = max(dot(n, l), 0.0);
    float cosBeta = max(dot(n, h), 0.0);
    return (texture(texDiff, tc).rgb * cosAlpha + texture(texSpec, tc).rgb * pow(cosBeta, shininess)) * lightColor;
}

// 1 in the inner cone, 0 outside of the outer one
float intensity(vec3 toLight) {
    float cosTheta = dot(-normalize(toLight), normalize(spotLight.direction));
    float cosInner = cos(spotLight.innerAngle);
    float cosOuter = cos(spotLight.outerAngle);
    return clamp((cosTheta - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
}

float attenuation(vec3 toLight, vec3 k) {
    float d = length(toLight);
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}
// end of solution

void main() {
    vec3 sum = texture(texEmit, tc).rgb;
    // solution 4.4: the emission in the colour of the object, which is a uniform
    // Lösung 4.4: die Emission in der Farbe des Objekts, einem Uniform
    sum *= tint;
    // end of solution
    // solution 4.2.3: add the diffuse and the specular part of the point light: a function will serve all lights
    // Lösung 4.2.3: Addieren Sie den diffusen und den spekularen Anteil des Punktlichts: Eine Funktion dient allen Lichtern
    // solution 4.3.3: add those of the spotlight, times its intensity I
    // Lösung 4.3.3: Addieren Sie die des Spotlights, mal dessen Intensität I
    // solution 4.3.4: let the light of both fade with the distance
    // Lösung 4.3.4: Schwächen Sie das Licht beider mit der Entfernung ab
    // solution 4.7: use the half vector in the specular part
    // Lösung 4.7: Verwenden Sie im spekularen Anteil den Half-Vector
    for (int i = 0; i < 5; i++) {
        sum += reflected(toPointLight[i], pointLight[i].color * attenuation(toPointLight[i], pointLight[i].attenuation));
    }
    sum += reflected(toSpotLight, spotLight.color * intensity(toSpotLight) * attenuation(toSpotLight, spotLight.attenuation));
    // end of solution
    color = vec4(sum, 1.0);
}
