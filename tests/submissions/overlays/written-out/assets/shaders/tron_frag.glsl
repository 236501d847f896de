#version 330 core

in vec2 tc;
in vec3 normalView;
in vec3 toCamera;
in vec3 toBike;
in vec3 toSpot;
in vec3 toCorner1;
in vec3 toCorner2;
in vec3 toCorner3;
in vec3 toCorner4;

// material
uniform sampler2D texEmit;
uniform sampler2D texDiff;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 tint;

// lights
uniform vec3 bikeColor;
uniform vec3 bikeAtt;
uniform vec3 spotColor;
uniform vec3 spotAtt;
uniform vec3 spotDir;
uniform float spotInner;
uniform float spotOuter;
uniform vec3 corner1Color;
uniform vec3 corner1Att;
uniform vec3 corner2Color;
uniform vec3 corner2Att;
uniform vec3 corner3Color;
uniform vec3 corner3Att;
uniform vec3 corner4Color;
uniform vec3 corner4Att;

out vec4 color;

void main() {
    vec3 emit = texture(texEmit, tc).rgb;
    vec3 diff = texture(texDiff, tc).rgb;
    vec3 spec = texture(texSpec, tc).rgb;
    vec3 n = normalize(normalView);
    vec3 v = normalize(toCamera);

    vec3 sum = emit * tint;
    // motorcycle
    vec3 l = normalize(toBike);
    vec3 h = normalize(l + v);
    float d = length(toBike);
    float f = 1.0 / (bikeAtt.x + bikeAtt.y * d + bikeAtt.z * d * d);
    sum += (diff * max(dot(n, l), 0.0) + spec * pow(max(dot(n, h), 0.0), shininess)) * bikeColor * f;

    // spot
    l = normalize(toSpot);
    h = normalize(l + v);
    d = length(toSpot);
    f = 1.0 / (spotAtt.x + spotAtt.y * d + spotAtt.z * d * d);
    float cosTheta = dot(-l, normalize(spotDir));
    f *= clamp((cosTheta - cos(spotOuter)) / (cos(spotInner) - cos(spotOuter)), 0.0, 1.0);
    sum += (diff * max(dot(n, l), 0.0) + spec * pow(max(dot(n, h), 0.0), shininess)) * spotColor * f;

    // corner1
    l = normalize(toCorner1);
    h = normalize(l + v);
    d = length(toCorner1);
    f = 1.0 / (corner1Att.x + corner1Att.y * d + corner1Att.z * d * d);
    sum += (diff * max(dot(n, l), 0.0) + spec * pow(max(dot(n, h), 0.0), shininess)) * corner1Color * f;

    // corner2
    l = normalize(toCorner2);
    h = normalize(l + v);
    d = length(toCorner2);
    f = 1.0 / (corner2Att.x + corner2Att.y * d + corner2Att.z * d * d);
    sum += (diff * max(dot(n, l), 0.0) + spec * pow(max(dot(n, h), 0.0), shininess)) * corner2Color * f;

    // corner3
    l = normalize(toCorner3);
    h = normalize(l + v);
    d = length(toCorner3);
    f = 1.0 / (corner3Att.x + corner3Att.y * d + corner3Att.z * d * d);
    sum += (diff * max(dot(n, l), 0.0) + spec * pow(max(dot(n, h), 0.0), shininess)) * corner3Color * f;

    // corner4
    l = normalize(toCorner4);
    h = normalize(l + v);
    d = length(toCorner4);
    f = 1.0 / (corner4Att.x + corner4Att.y * d + corner4Att.z * d * d);
    sum += (diff * max(dot(n, l), 0.0) + spec * pow(max(dot(n, h), 0.0), shininess)) * corner4Color * f;

    color = vec4(sum, 1.0);
}
