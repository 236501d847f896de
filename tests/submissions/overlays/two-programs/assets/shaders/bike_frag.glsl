#version 330 core

// what the motorcycle looks like; the ground has its own shader

in vec2 tc;
in vec3 normalView;
in vec3 toCamera;
in vec3 toBike;
in vec3 toSpot;
in vec3 toCorner1;
in vec3 toCorner2;
in vec3 toCorner3;
in vec3 toCorner4;

uniform sampler2D texEmit;
uniform sampler2D texDiff;
uniform sampler2D texSpec;
uniform float shininess;
uniform vec3 tint;

uniform vec3 bikeColor, bikeAtt;
uniform vec3 spotColor, spotAtt, spotDir;
uniform float spotInner, spotOuter;
uniform vec3 corner1Color, corner1Att;
uniform vec3 corner2Color, corner2Att;
uniform vec3 corner3Color, corner3Att;
uniform vec3 corner4Color, corner4Att;

out vec4 color;

vec3 lit(vec3 toLight, vec3 lightColor, vec3 k) {
    vec3 normal = normalize(normalView);
    vec3 light = normalize(toLight);
    vec3 between = normalize(light + normalize(toCamera));
    float d = length(toLight);
    float specular = pow(max(dot(normal, between), 0.0), shininess);
    float diffuse = max(dot(normal, light), 0.0);
    vec3 reflected = texture(texDiff, tc).rgb * diffuse + texture(texSpec, tc).rgb * specular;
    return reflected * lightColor / (k.x + (k.y + k.z * d) * d);
}

void main() {
    vec3 sum = lit(toBike, bikeColor, bikeAtt)
        + lit(toCorner1, corner1Color, corner1Att)
        + lit(toCorner2, corner2Color, corner2Att)
        + lit(toCorner3, corner3Color, corner3Att)
        + lit(toCorner4, corner4Color, corner4Att);

    float cosTheta = dot(normalize(-toSpot), normalize(spotDir));
    float inCone = clamp((cosTheta - cos(spotOuter)) / (cos(spotInner) - cos(spotOuter)), 0.0, 1.0);
    sum += lit(toSpot, spotColor, spotAtt) * inCone;

    color = vec4(tint * texture(texEmit, tc).rgb + sum, 1.0);
}
