#version 330 core
//#include camera.glsl
//#include lights.glsl

layout(location = 0) in vec3 in_position;

uniform int firstLamp;
uniform float lampSize;

flat out vec3 lampColor;

void main() {
    Light lamp = lights[firstLamp + gl_InstanceID];
    lampColor = lamp.color / max(max(lamp.color.r, lamp.color.g), lamp.color.b);
    gl_Position = projection * vec4(lamp.position + mat3(view) * in_position * lampSize, 1.0);
}
