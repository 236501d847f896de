#version 330 core
// The panel: triangles in window coordinates, from the upper left corner.

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec4 color;

uniform vec2 windowSize;

out vec2 glyph;
out vec4 tint;

void main() {
    glyph = texCoord;
    tint = color;
    gl_Position = vec4(position.x / windowSize.x * 2.0 - 1.0, 1.0 - position.y / windowSize.y * 2.0, 0.0, 1.0);
}
