#version 330 core

in vec2 tc;
in vec3 Normal;
in vec3 toCamera;
in vec3 toPointLight;
in vec3 toSpotLight;
in vec3 toEcke[4];

uniform sampler2D diffTex;
uniform sampler2D specTex;
uniform sampler2D emitTex;
uniform float shininess;
uniform vec3 farbe;

uniform vec3 pointLightColor;
uniform vec3 eckColor[4];

struct SpotLight {
    vec3 position;
    vec3 direction;
    vec3 color;
    float cutOff;
    float outerCutOff;
};
uniform SpotLight spotLight;

out vec4 FragColor;

vec3 linear(vec3 c) {
    return pow(c, vec3(2.2));
}

vec3 gammaKorrektur(vec3 c) {
    return pow(c, vec3(1.0 / 2.2));
}

float diffuseTerm(vec3 N, vec3 L) {
    return max(dot(N, L), 0.0);
}

// blinn
float specularTerm(vec3 N, vec3 L, vec3 V) {
    vec3 H = normalize(L + V);
    return pow(max(dot(N, H), 0.0), shininess);
}

float abschwaechung(vec3 toLight) {
    float d = length(toLight);
    return 1.0 / (d * d);
}

void main() {
    vec3 N = normalize(Normal);
    vec3 V = normalize(toCamera);

    vec3 Md = linear(texture(diffTex, tc).rgb);
    vec3 Ms = texture(specTex, tc).rgb;
    vec3 Me = linear(texture(emitTex, tc).rgb);

    // emission
    vec3 result = Me * farbe;

    // Punktlicht am Motorrad
    vec3 L = normalize(toPointLight);
    result += (Md * diffuseTerm(N, L) + Ms * specularTerm(N, L, V)) * pointLightColor * abschwaechung(toPointLight);

    // Scheinwerfer, see learnopengl light casters
    vec3 lightDir = normalize(toSpotLight);
    float theta = dot(lightDir, normalize(-spotLight.direction));
    float epsilon = spotLight.cutOff - spotLight.outerCutOff;
    float intensity = clamp((theta - spotLight.outerCutOff) / epsilon, 0.0, 1.0);
    vec3 diffuse = Md * diffuseTerm(N, lightDir) * intensity;
    vec3 specular = Ms * specularTerm(N, lightDir, V) * intensity;
    result += (diffuse + specular) * spotLight.color * abschwaechung(toSpotLight);

    // Ecken
    for (int i = 0; i < 4; i++) {
        vec3 Li = normalize(toEcke[i]);
        vec3 Lo = eckColor[i] * abschwaechung(toEcke[i]);
        result += Md * diffuseTerm(N, Li) * Lo;
        result += Ms * specularTerm(N, Li, V) * Lo;
    }

    FragColor = vec4(gammaKorrektur(result), 1.0);
}
