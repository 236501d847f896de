#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texcoords;
layout(location = 2) in vec3 normal;

//uniforms
// translation object to world
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;
uniform vec2 tcMultiplier;

// Aufgabe 4.2 / 4.3: Positionen der Lichter
uniform vec3 pointLight_pos;
uniform vec3 spotLight_pos;
// Aufgabe 4.6
uniform vec3 eckeRot_pos;
uniform vec3 eckeBlau_pos;
uniform vec3 eckeGelb_pos;
uniform vec3 eckeLila_pos;

out struct VertexData
{
    vec2 texcoords;
    vec3 normal;
    vec3 toCamera;
    vec3 toPointLight;
    vec3 toSpotLight;
    vec3 toEckeRot;
    vec3 toEckeBlau;
    vec3 toEckeGelb;
    vec3 toEckeLila;
} vertexData;

//
void main(){
    mat4 modelView = view_matrix * model_matrix;
    vec4 pos = modelView * vec4(position, 1.0f);

    // Normale in den Viewspace, w = 0 weil Richtung!
    mat4 normalMat = transpose(inverse(modelView));
    vertexData.normal = (normalMat * vec4(normal, 0.0f)).xyz;

    // alle Lichter: Welt -> View, dann Licht minus Position
    // NICHT hier normalisieren (steht auf dem Zettel)
    vec4 lp = view_matrix * vec4(pointLight_pos, 1.0f);
    vertexData.toPointLight = (lp - pos).xyz;

    vec4 sp = view_matrix * vec4(spotLight_pos, 1.0f);
    vertexData.toSpotLight = (sp - pos).xyz;

    vec4 rot = view_matrix * vec4(eckeRot_pos, 1.0f);
    vertexData.toEckeRot = (rot - pos).xyz;

    vec4 blau = view_matrix * vec4(eckeBlau_pos, 1.0f);
    vertexData.toEckeBlau = (blau - pos).xyz;

    vec4 gelb = view_matrix * vec4(eckeGelb_pos, 1.0f);
    vertexData.toEckeGelb = (gelb - pos).xyz;

    vec4 lila = view_matrix * vec4(eckeLila_pos, 1.0f);
    vertexData.toEckeLila = (lila - pos).xyz;

    // Kamera ist im Viewspace bei 0,0,0
    vertexData.toCamera = -pos.xyz;

    vertexData.texcoords = texcoords * tcMultiplier;
    gl_Position = proj_matrix * pos;
}
