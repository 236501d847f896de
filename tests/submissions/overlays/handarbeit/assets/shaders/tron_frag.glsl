#version 330 core

//input from vertex shader
in struct VertexData
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

// Material
uniform sampler2D diff;
uniform sampler2D emit;
uniform sampler2D specular;
uniform float shininess;
// Farbe aus dem RenderCall (4.4)
uniform vec3 farbe;

// Punktlicht am Motorrad
uniform vec3 pointLight_color;
uniform vec3 pointLight_att;

// Scheinwerfer
uniform vec3 spotLight_color;
uniform vec3 spotLight_att;
uniform vec3 spotLight_dir;
uniform vec2 spotLight_angle;   // x = innen, y = aussen (rad)

// Ecken
uniform vec3 eckeRot_color;
uniform vec3 eckeRot_att;
uniform vec3 eckeBlau_color;
uniform vec3 eckeBlau_att;
uniform vec3 eckeGelb_color;
uniform vec3 eckeGelb_att;
uniform vec3 eckeLila_color;
uniform vec3 eckeLila_att;

//fragment shader output
out vec4 color;

void main(){
    vec3 diffTex = texture(diff, vertexData.texcoords).rgb;
    vec3 emitTex = texture(emit, vertexData.texcoords).rgb;
    vec3 specTex = texture(specular, vertexData.texcoords).rgb;

    vec3 n = normalize(vertexData.normal);
    vec3 v = normalize(vertexData.toCamera);

    // emissiver Anteil
    vec3 result = emitTex * farbe;

    // ---------- Punktlicht ----------
    float dPoint = length(vertexData.toPointLight);
    vec3 lPoint = normalize(vertexData.toPointLight);
    float attPoint = 1.0 / (pointLight_att.x + pointLight_att.y * dPoint + pointLight_att.z * dPoint * dPoint);
    float cosAPoint = max(dot(n, lPoint), 0.0);
    // vec3 rPoint = reflect(-lPoint, n);
    // float cosBPoint = max(dot(v, rPoint), 0.0);
    vec3 hPoint = normalize(lPoint + v);
    float cosBPoint = max(dot(n, hPoint), 0.0);
    result += (diffTex * cosAPoint + specTex * pow(cosBPoint, shininess)) * pointLight_color * attPoint;

    // ---------- Scheinwerfer ----------
    float dSpot = length(vertexData.toSpotLight);
    vec3 lSpot = normalize(vertexData.toSpotLight);
    float attSpot = 1.0 / (spotLight_att.x + spotLight_att.y * dSpot + spotLight_att.z * dSpot * dSpot);
    float cosTheta = dot(lSpot, normalize(-spotLight_dir));
    float cosInnen = cos(spotLight_angle.x);
    float cosAussen = cos(spotLight_angle.y);
    float intensity = clamp((cosTheta - cosAussen) / (cosInnen - cosAussen), 0.0, 1.0);
    float cosASpot = max(dot(n, lSpot), 0.0);
    // vec3 rSpot = reflect(-lSpot, n);
    // float cosBSpot = max(dot(v, rSpot), 0.0);
    vec3 hSpot = normalize(lSpot + v);
    float cosBSpot = max(dot(n, hSpot), 0.0);
    result += (diffTex * cosASpot + specTex * pow(cosBSpot, shininess)) * spotLight_color * intensity * attSpot;

    // ---------- Ecke rot ----------
    float dRot = length(vertexData.toEckeRot);
    vec3 lRot = normalize(vertexData.toEckeRot);
    float attRot = 1.0 / (eckeRot_att.x + eckeRot_att.y * dRot + eckeRot_att.z * dRot * dRot);
    float cosARot = max(dot(n, lRot), 0.0);
    vec3 hRot = normalize(lRot + v);
    float cosBRot = max(dot(n, hRot), 0.0);
    result += (diffTex * cosARot + specTex * pow(cosBRot, shininess)) * eckeRot_color * attRot;

    // ---------- Ecke blau ----------
    float dBlau = length(vertexData.toEckeBlau);
    vec3 lBlau = normalize(vertexData.toEckeBlau);
    float attBlau = 1.0 / (eckeBlau_att.x + eckeBlau_att.y * dBlau + eckeBlau_att.z * dBlau * dBlau);
    float cosABlau = max(dot(n, lBlau), 0.0);
    vec3 hBlau = normalize(lBlau + v);
    float cosBBlau = max(dot(n, hBlau), 0.0);
    result += (diffTex * cosABlau + specTex * pow(cosBBlau, shininess)) * eckeBlau_color * attBlau;

    // ---------- Ecke gelb ----------
    float dGelb = length(vertexData.toEckeGelb);
    vec3 lGelb = normalize(vertexData.toEckeGelb);
    float attGelb = 1.0 / (eckeGelb_att.x + eckeGelb_att.y * dGelb + eckeGelb_att.z * dGelb * dGelb);
    float cosAGelb = max(dot(n, lGelb), 0.0);
    vec3 hGelb = normalize(lGelb + v);
    float cosBGelb = max(dot(n, hGelb), 0.0);
    result += (diffTex * cosAGelb + specTex * pow(cosBGelb, shininess)) * eckeGelb_color * attGelb;

    // ---------- Ecke lila ----------
    float dLila = length(vertexData.toEckeLila);
    vec3 lLila = normalize(vertexData.toEckeLila);
    float attLila = 1.0 / (eckeLila_att.x + eckeLila_att.y * dLila + eckeLila_att.z * dLila * dLila);
    float cosALila = max(dot(n, lLila), 0.0);
    vec3 hLila = normalize(lLila + v);
    float cosBLila = max(dot(n, hLila), 0.0);
    result += (diffTex * cosALila + specTex * pow(cosBLila, shininess)) * eckeLila_color * attLila;

    color = vec4(result, 1.0f);
    // color = vec4(n, 1.0f);       // Test Normalen
    // color = vec4(vec3(intensity), 1.0f);
}
