#version 330 core
in vec2 tc;
in vec3 norm;
in vec3 toCamera;
in vec3 toLight;
in vec3 toSpot;
in vec3 toLight2;
in vec3 toLight3;
in vec3 toLight4;
in vec3 toLight5;

uniform sampler2D tex_emit;
uniform sampler2D tex_diff;
uniform sampler2D tex_spec;
uniform float shininess;
uniform vec3 emit_col;

uniform vec3 light_col;
uniform vec3 light_att;
uniform vec3 spot_col;
uniform vec3 spot_att;
uniform vec3 spot_dir;
uniform float spot_inner;
uniform float spot_outer;
uniform vec3 light2_col;
uniform vec3 light2_att;
uniform vec3 light3_col;
uniform vec3 light3_att;
uniform vec3 light4_col;
uniform vec3 light4_att;
uniform vec3 light5_col;
uniform vec3 light5_att;

out vec4 color;

void main() {
    vec3 emit = texture(tex_emit, tc).xyz;
    vec3 diff = texture(tex_diff, tc).xyz;
    vec3 spec = texture(tex_spec, tc).xyz;

    vec3 n = normalize(norm);
    vec3 v = normalize(toCamera);

    // motorcycle light
    float d = length(toLight);
    vec3 l = normalize(toLight);
    vec3 h = normalize(l + v);
    float cosa = max(0.0, dot(n, l));
    float cosb = max(0.0, dot(n, h));
    float att = 1.0 / (light_att.x + light_att.y * d + light_att.z * d * d);
    vec3 result = (diff * cosa + spec * pow(cosb, shininess)) * light_col * att;

    // spotlight
    float sd = length(toSpot);
    vec3 sl = normalize(toSpot);
    vec3 sh = normalize(sl + v);
    float scosa = max(0.0, dot(n, sl));
    float scosb = max(0.0, dot(n, sh));
    float satt = 1.0 / (spot_att.x + spot_att.y * sd + spot_att.z * sd * sd);
    float costheta = dot(-sl, normalize(spot_dir));
    float intensity = (costheta - cos(spot_outer)) / (cos(spot_inner) - cos(spot_outer));
    intensity = clamp(intensity, 0.0, 1.0);
    result += (diff * scosa + spec * pow(scosb, shininess)) * spot_col * satt * intensity;

    // light 2
    float d2 = length(toLight2);
    vec3 l2 = normalize(toLight2);
    vec3 h2 = normalize(l2 + v);
    float cosa2 = max(0.0, dot(n, l2));
    float cosb2 = max(0.0, dot(n, h2));
    float att2 = 1.0 / (light2_att.x + light2_att.y * d2 + light2_att.z * d2 * d2);
    result += (diff * cosa2 + spec * pow(cosb2, shininess)) * light2_col * att2;

    // light 3
    float d3 = length(toLight3);
    vec3 l3 = normalize(toLight3);
    vec3 h3 = normalize(l3 + v);
    float cosa3 = max(0.0, dot(n, l3));
    float cosb3 = max(0.0, dot(n, h3));
    float att3 = 1.0 / (light3_att.x + light3_att.y * d3 + light3_att.z * d3 * d3);
    result += (diff * cosa3 + spec * pow(cosb3, shininess)) * light3_col * att3;

    // light 4
    float d4 = length(toLight4);
    vec3 l4 = normalize(toLight4);
    vec3 h4 = normalize(l4 + v);
    float cosa4 = max(0.0, dot(n, l4));
    float cosb4 = max(0.0, dot(n, h4));
    float att4 = 1.0 / (light4_att.x + light4_att.y * d4 + light4_att.z * d4 * d4);
    result += (diff * cosa4 + spec * pow(cosb4, shininess)) * light4_col * att4;

    // light 5
    float d5 = length(toLight5);
    vec3 l5 = normalize(toLight5);
    vec3 h5 = normalize(l5 + v);
    float cosa5 = max(0.0, dot(n, l5));
    float cosb5 = max(0.0, dot(n, h5));
    float att5 = 1.0 / (light5_att.x + light5_att.y * d5 + light5_att.z * d5 * d5);
    result += (diff * cosa5 + spec * pow(cosb5, shininess)) * light5_col * att5;

    color = vec4(result + emit * emit_col, 1.0);
}
