#version 330 core

const int POINT_LIGHTS = 5;

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    PointLight source;
    vec3 direction;
    float cosInner;
    float cosOuter;
};

struct Material {
    sampler2D diffuse;
    sampler2D emissive;
    sampler2D specular;
    float shininess;
};

// what is to be lit
struct Surface {
    vec3 normal;
    vec3 toCamera;
    vec3 diffuse;
    vec3 specular;
    float shininess;
};

// what comes back from it
struct Reflection {
    vec3 diffuse;
    vec3 specular;
};

in vec2 uv;
in vec3 viewNormal;
in vec3 toCamera;
in vec3 toPoints[POINT_LIGHTS];
in vec3 toSpot;

uniform PointLight points[POINT_LIGHTS];
uniform SpotLight spot;
uniform Material material;
uniform vec3 glow;

out vec4 color;

Surface readSurface() {
    return Surface(
        normalize(viewNormal),
        normalize(toCamera),
        texture(material.diffuse, uv).rgb,
        texture(material.specular, uv).rgb,
        material.shininess
    );
}

Reflection add(Reflection a, Reflection b) {
    return Reflection(a.diffuse + b.diffuse, a.specular + b.specular);
}

Reflection scale(Reflection r, float factor) {
    return Reflection(r.diffuse * factor, r.specular * factor);
}

float fade(vec3 k, float d) {
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

float coneIntensity(SpotLight light, vec3 l) {
    float cosTheta = dot(light.direction, -l);
    float intensity = (cosTheta - light.cosOuter) / (light.cosInner - light.cosOuter);
    return clamp(intensity, 0.0, 1.0);
}

// Blinn-Phong
Reflection fromPoint(PointLight light, vec3 toLight, Surface s) {
    vec3 l = normalize(toLight);
    vec3 h = normalize(l + s.toCamera);
    float cosAlpha = max(dot(s.normal, l), 0.0);
    float cosBeta = max(dot(s.normal, h), 0.0);
    vec3 arriving = light.color * fade(light.attenuation, length(toLight));
    return Reflection(
        arriving * cosAlpha,
        arriving * pow(cosBeta, s.shininess)
    );
}

Reflection fromSpot(SpotLight light, vec3 toLight, Surface s) {
    float intensity = coneIntensity(light, normalize(toLight));
    return scale(fromPoint(light.source, toLight, s), intensity);
}

void main() {
    Surface s = readSurface();
    vec3 emission = texture(material.emissive, uv).rgb * glow;

    Reflection sum = fromSpot(spot, toSpot, s);
    for (int i = 0; i < POINT_LIGHTS; i++) {
        sum = add(sum, fromPoint(points[i], toPoints[i], s));
    }
    color = vec4(emission + s.diffuse * sum.diffuse + s.specular * sum.specular, 1.0);
}
