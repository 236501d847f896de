#version 330 core
in vec2 fUv;
in vec3 fNormal;
in vec3 fPosition;

out vec4 pixel;

struct Material { sampler2D emissive, diffuse, specular; float shininess; };
struct Lamp { vec3 position, color, factors; };
struct Beam { Lamp lamp; vec3 axis; float gamma, phi; };

uniform Material material;
uniform vec3 emission;
// in view space
uniform Lamp own;
uniform Lamp corners[4];
uniform Beam beam;

vec3 N, V, Md, Ms;

float fade(in Lamp lamp) {
    float d = distance(lamp.position, fPosition);
    return 1.0 / (lamp.factors[0] + lamp.factors[1] * d + lamp.factors[2] * d * d);
}

void illuminate(in Lamp lamp, in float intensity, inout vec3 light) {
    vec3 Li = lamp.color * intensity * fade(lamp);
    vec3 L = normalize(lamp.position - fPosition);
    vec3 H = normalize(L + V);
    vec3 C = Md * max(dot(N, L), 0.0);
    vec3 D = Ms * pow(max(dot(N, H), 0.0), material.shininess);
    light += (C + D) * Li;
}

float inCone(in Beam b) {
    float cosTheta = dot(normalize(fPosition - b.lamp.position), b.axis);
    return clamp((cosTheta - cos(b.phi)) / (cos(b.gamma) - cos(b.phi)), 0.0, 1.0);
}

void main() {
    N = normalize(fNormal);
    V = -normalize(fPosition);
    Md = texture(material.diffuse, fUv).rgb;
    Ms = texture(material.specular, fUv).rgb;

    vec3 light = texture(material.emissive, fUv).rgb * emission;
    illuminate(own, 1.0, light);
    illuminate(corners[0], 1.0, light);
    illuminate(corners[1], 1.0, light);
    illuminate(corners[2], 1.0, light);
    illuminate(corners[3], 1.0, light);
    illuminate(beam.lamp, inCone(beam), light);
    pixel = vec4(light, 1);
}
