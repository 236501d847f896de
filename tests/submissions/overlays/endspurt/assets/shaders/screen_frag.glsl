#version 330 core

in vec2 TexCoords;

uniform sampler2D screenTexture;
// 0: Vignette, 1: nichts, 2: Graustufen, 3: Negativ
uniform int effect;

out vec4 FragColor;

void main() {
    vec3 bild = texture(screenTexture, TexCoords).rgb;
    if (effect == 0) {
        float abstand = distance(TexCoords, vec2(0.5));
        bild *= 1.0 - 0.6 * smoothstep(0.45, 0.75, abstand);
    } else if (effect == 2) {
        bild = vec3(dot(bild, vec3(0.2126, 0.7152, 0.0722)));
    } else if (effect == 3) {
        bild = 1.0 - bild;
    }
    FragColor = vec4(bild, 1.0);
}
