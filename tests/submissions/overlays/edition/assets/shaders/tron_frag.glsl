#version 330 core

#define POINT_LIGHTS 5

struct PointLight {
  vec3 position;
  vec3 color;
};

struct SpotLight {
  vec3 position;
  vec3 color;
  vec3 direction;
  vec2 cone;
};

in struct VertexData
{
  vec3 normal;
  vec2 tc;
  vec3 toCamera;
  vec3 toPointLight[POINT_LIGHTS];
  vec3 toSpotLight;
} vertexData;

uniform PointLight pointLights[POINT_LIGHTS];
uniform SpotLight spotLight;

uniform sampler2D material_diff;
uniform sampler2D material_emit;
uniform sampler2D material_specular;
uniform float material_shininess;
uniform vec3 emission_color;

out vec4 color;

const float gamma = 2.2f;

//sRGB -> linear
vec3 gammaInverse(vec3 c) {
  return pow(c, vec3(gamma));
}

//linear -> sRGB
vec3 gammaCorrect(vec3 c) {
  return pow(c, vec3(1.0f / gamma));
}

//inverse square law
float attenuate(float distance) {
  return 1.0f / (distance * distance);
}

vec3 blinnPhong(vec3 n, vec3 l, vec3 v, vec3 diffuse, vec3 specular) {
  float cosAlpha = max(0.0f, dot(n, l));
  vec3 halfway = normalize(l + v);
  float cosBeta = max(0.0f, dot(n, halfway));
  return diffuse * cosAlpha + specular * pow(cosBeta, material_shininess);
}

float coneIntensity(vec3 l) {
  float cosTheta = dot(normalize(spotLight.direction), -l);
  float cosGamma = cos(spotLight.cone.x);
  float cosPhi = cos(spotLight.cone.y);
  return clamp((cosTheta - cosPhi) / (cosGamma - cosPhi), 0.0f, 1.0f);
}

void main(){
  vec3 diffuse = gammaInverse(texture(material_diff, vertexData.tc).rgb);
  vec3 emission = gammaInverse(texture(material_emit, vertexData.tc).rgb);
  vec3 specular = texture(material_specular, vertexData.tc).rgb;

  vec3 n = normalize(vertexData.normal);
  vec3 v = normalize(vertexData.toCamera);

  vec3 result = emission * emission_color;

  for (int i = 0; i < POINT_LIGHTS; i++) {
    vec3 toLight = vertexData.toPointLight[i];
    vec3 radiance = pointLights[i].color * attenuate(length(toLight));
    result += blinnPhong(n, normalize(toLight), v, diffuse, specular) * radiance;
  }

  vec3 l = normalize(vertexData.toSpotLight);
  vec3 radiance = spotLight.color * coneIntensity(l) * attenuate(length(vertexData.toSpotLight));
  result += blinnPhong(n, l, v, diffuse, specular) * radiance;

  color = vec4(gammaCorrect(result), 1.0f);
}
