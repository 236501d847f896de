#version 330 core
// The panel: a colour times what the font's texture says.

in vec2 glyph;
in vec4 tint;

uniform sampler2D font;

out vec4 fragColor;

void main() {
    fragColor = tint * texture(font, glyph);
}
