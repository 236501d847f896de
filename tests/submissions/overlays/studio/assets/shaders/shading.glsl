//#include lights.glsl

uniform sampler2D diffuseMap;
uniform sampler2D emissiveMap;
uniform sampler2D specularMap;
uniform float shininess;
uniform vec3 emissionColor;

vec3 shade(vec3 position, vec3 n, vec2 uv) {
    vec3 v = normalize(-position);
    vec3 diffuse = texture(diffuseMap, uv).rgb;
    vec3 specular = texture(specularMap, uv).rgb;
    vec3 sum = texture(emissiveMap, uv).rgb * emissionColor;

    for (int i = 0; i < lightCount; i++) {
        Light light = lights[i];
        vec3 toLight = light.position - position;
        float d = length(toLight);
        vec3 l = toLight / d;

        vec3 radiance = light.color / (light.k.x + light.k.y * d + light.k.z * d * d);
        if (light.isSpot > 0.5) {
            float cosTheta = dot(light.direction, -l);
            radiance *= clamp((cosTheta - light.outer) / (light.inner - light.outer), 0.0, 1.0);
        }

        float nl = max(dot(n, l), 0.0);
        vec3 h = normalize(l + v);
        float nh = nl > 0.0 ? max(dot(n, h), 0.0) : 0.0;
        sum += (diffuse * nl + specular * pow(nh, shininess)) * radiance;
    }
    return sum;
}
