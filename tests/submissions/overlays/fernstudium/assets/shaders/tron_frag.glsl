#version 330 core

// muss zu PointLight.MAX_LICHTER passen!
const int MAX_LIGHTS = 8;

const int TYPE_POINT = 0;
const int TYPE_SPOT  = 1;

in vec3 v_posVS;
in vec3 v_normVS;
in vec2 v_tc;

uniform mat4 u_view;

// Material
uniform sampler2D u_texDiff;
uniform sampler2D u_texEmit;
uniform sampler2D u_texSpec;
uniform float     u_shininess;
uniform vec3      u_emitCol;

// Lichter: parallele Arrays, ein Slot je Licht, der Scheinwerfer im letzten belegten Slot
uniform int   u_lightCount;
uniform int   u_lightType[MAX_LIGHTS];
uniform vec3  u_lightPos[MAX_LIGHTS];       // Weltkoordinaten
uniform vec3  u_lightCol[MAX_LIGHTS];
uniform vec3  u_lightAtt[MAX_LIGHTS];       // x = Kc, y = Kl, z = Kq
uniform vec3  u_lightDir[MAX_LIGHTS];       // Viewspace, nur TYPE_SPOT
uniform float u_lightInner[MAX_LIGHTS];     // [rad], nur TYPE_SPOT
uniform float u_lightOuter[MAX_LIGHTS];     // [rad], nur TYPE_SPOT

out vec4 o_color;

// Abschwaechung nach Blatt 4.3.4
float calcAttenuation(const in vec3 k, const in float d)
{
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

// Intensitaet im Kegel: 1 = innen, 0 = aussen, dazwischen linear im Cosinus
float calcCone(const in int i, const in vec3 l)
{
    if (u_lightType[i] == TYPE_POINT) {
        return 1.0;
    }
    float cosTheta = dot(-l, normalize(u_lightDir[i]));
    float cosInner = cos(u_lightInner[i]);
    float cosOuter = cos(u_lightOuter[i]);
    return clamp((cosTheta - cosOuter) / (cosInner - cosOuter), 0.0, 1.0);
}

void main()
{
    // 1. Eingaenge
    vec3 texDiff = texture(u_texDiff, v_tc).rgb;
    vec3 texEmit = texture(u_texEmit, v_tc).rgb;
    vec3 texSpec = texture(u_texSpec, v_tc).rgb;

    vec3 n = normalize(v_normVS);
    vec3 v = normalize(-v_posVS);       // Kamera = Ursprung

    // 2. Akkumulatoren fuer alle Lichter
    vec3 sumDiff = vec3(0.0);
    vec3 sumSpec = vec3(0.0);

    for (int i = 0; i < MAX_LIGHTS; ++i) {
        if (i >= u_lightCount) {
            break;
        }

        vec3  posVS   = (u_view * vec4(u_lightPos[i], 1.0)).xyz;
        vec3  toLight = posVS - v_posVS;
        float dist    = length(toLight);
        vec3  l       = normalize(toLight);

        float att  = calcAttenuation(u_lightAtt[i], dist);
        float cone = calcCone(i, l);
        vec3  col  = u_lightCol[i] * (att * cone);

        // diffus
        float cosAlpha = max(dot(n, l), 0.0);
        sumDiff += col * cosAlpha;

        // spekular, Blinn-Phong (4.7), vorher: dot(reflect(-l, n), v)
        vec3  h       = normalize(l + v);
        float cosBeta = max(dot(n, h), 0.0);
        sumSpec += col * pow(cosBeta, u_shininess);
    }

    // 3. Ausgang
    vec3 sum = texEmit * u_emitCol + texDiff * sumDiff + texSpec * sumSpec;
    o_color = vec4(sum, 1.0);
}
