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
    d = length(toSpot);
    l = toSpot / d;
    h = normalize(l + v);
    cosa = max(0.0, dot(n, l));
    cosb = max(0.0, dot(n, h));
    att = 1.0 / (spot_att.x + d * (spot_att.y + spot_att.z * d));
    float cosOuter = cos(spot_outer);
    // the intensity goes into the attenuation right away
    att *= clamp((dot(-l, normalize(spot_dir)) - cosOuter) / (cos(spot_inner) - cosOuter), 0.0, 1.0);
    result += (diff * cosa + spec * pow(cosb, shininess)) * spot_col * att;

    // light 2, with the variables from above again
    d = length(toLight2);
    l = toLight2 / d;
    h = normalize(l + v);
    cosa = max(0.0, dot(n, l));
    cosb = max(0.0, dot(n, h));
    att = 1.0 / (light2_att.x + d * (light2_att.y + light2_att.z * d));
    result += (diff * cosa + spec * pow(cosb, shininess)) * light2_col * att;

    // light 3, with the variables from above again
    d = length(toLight3);
    l = toLight3 / d;
    h = normalize(l + v);
    cosa = max(0.0, dot(n, l));
    cosb = max(0.0, dot(n, h));
    att = 1.0 / (light3_att.x + d * (light3_att.y + light3_att.z * d));
    result += (diff * cosa + spec * pow(cosb, shininess)) * light3_col * att;

    // light 4, with the variables from above again
    d = length(toLight4);
    l = toLight4 / d;
    h = normalize(l + v);
    cosa = max(0.0, dot(n, l));
    cosb = max(0.0, dot(n, h));
    att = 1.0 / (light4_att.x + d * (light4_att.y + light4_att.z * d));
    result += (diff * cosa + spec * pow(cosb, shininess)) * light4_col * att;

    // light 5, with the variables from above again
    d = length(toLight5);
    l = toLight5 / d;
    h = normalize(l + v);
    cosa = max(0.0, dot(n, l));
    cosb = max(0.0, dot(n, h));
    att = 1.0 / (light5_att.x + d * (light5_att.y + light5_att.z * d));
    result += (diff * cosa + spec * pow(cosb, shininess)) * light5_col * att;

    color = vec4(result + emit * emit_col, 1.0);
}
