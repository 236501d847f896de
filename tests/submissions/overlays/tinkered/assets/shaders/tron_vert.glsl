#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 textur;
layout(location = 2) in vec3 normale;

uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 kacheln;

// Lampen in Weltkoordinaten
uniform vec3 motorradLicht_position;
uniform vec3 scheinwerfer_position;
uniform vec3 rot_position;
uniform vec3 blau_position;
uniform vec3 gelb_position;
uniform vec3 tuerkis_position;

out vec2 tc;
out vec3 N;
out vec3 zurKamera;
out vec3 zumMotorradLicht;
out vec3 zumScheinwerfer;
out vec3 zuRot;
out vec3 zuBlau;
out vec3 zuGelb;
out vec3 zuTuerkis;

void main() {
    vec4 lokal = vec4(position, 1.0);
    vec4 welt = model_matrix * lokal;
    vec4 viewspace = view_matrix * welt;
    gl_Position = projection_matrix * viewspace;

    tc = vec2(textur.x * kacheln.x, textur.y * kacheln.y);

    // Normale: 0 hinten, damit sie nicht verschoben wird
    mat4 normalMatrix = transpose(inverse(view_matrix * model_matrix));
    vec4 n4 = normalMatrix * vec4(normale, 0.0);
    N = n4.xyz;

    // Kamera ist im View Space bei 0 0 0
    vec3 hier = viewspace.xyz;
    vec3 kamera = vec3(0.0, 0.0, 0.0);
    zurKamera = kamera - hier;

    vec4 motorradLichtView = view_matrix * vec4(motorradLicht_position, 1.0);
    zumMotorradLicht = motorradLichtView.xyz - hier;

    vec4 scheinwerferView = view_matrix * vec4(scheinwerfer_position, 1.0);
    zumScheinwerfer = scheinwerferView.xyz - hier;

    vec4 rotView = view_matrix * vec4(rot_position, 1.0);
    zuRot = rotView.xyz - hier;

    vec4 blauView = view_matrix * vec4(blau_position, 1.0);
    zuBlau = blauView.xyz - hier;

    vec4 gelbView = view_matrix * vec4(gelb_position, 1.0);
    zuGelb = gelbView.xyz - hier;

    vec4 tuerkisView = view_matrix * vec4(tuerkis_position, 1.0);
    zuTuerkis = tuerkisView.xyz - hier;
}
