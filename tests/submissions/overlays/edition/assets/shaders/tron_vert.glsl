#version 330 core

#define POINT_LIGHTS 5

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

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

//uniforms
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;
uniform PointLight pointLights[POINT_LIGHTS];
uniform SpotLight spotLight;

out struct VertexData
{
  vec3 normal;
  vec2 tc;
  vec3 toCamera;
  vec3 toPointLight[POINT_LIGHTS];
  vec3 toSpotLight;
} vertexData;

void main(){
  mat4 modelView = view_matrix * model_matrix;
  vec3 viewPos = (modelView * vec4(position, 1.0f)).xyz;

  vertexData.normal = inverse(transpose(mat3(modelView))) * normal;
  vertexData.tc = texCoord * tcMultiplier;
  vertexData.toCamera = -viewPos;

  for (int i = 0; i < POINT_LIGHTS; i++) {
    vec4 lightPos = view_matrix * vec4(pointLights[i].position, 1.0f);
    vertexData.toPointLight[i] = lightPos.xyz - viewPos;
  }
  vec4 spotPos = view_matrix * vec4(spotLight.position, 1.0f);
  vertexData.toSpotLight = spotPos.xyz - viewPos;

  gl_Position = projection_matrix * vec4(viewPos, 1.0f);
}
