#version 330 core

in vec2 tc;
in vec3 nrm;
in vec3 zucam;
in vec3 zupl;
in vec3 zusw;
in vec3 zul2;
in vec3 zul3;
in vec3 zul4;
in vec3 zul5;

// material
uniform sampler2D tdif;
uniform sampler2D tspe;
uniform sampler2D temi;
uniform float shin;
uniform vec3 emcol;

// licht am bike
uniform vec3 colpl;
uniform vec3 kpl;
// scheinwerfer
uniform vec3 colsw;
uniform vec3 ksw;
uniform vec3 dirsw;
uniform float innsw;
uniform float aussw;
// 4.6
uniform vec3 coll2;
uniform vec3 coll3;
uniform vec3 coll4;
uniform vec3 coll5;

out vec4 col;

void main() {
    vec3 dif = texture(tdif, tc).rgb;
    vec3 spe = texture(tspe, tc).rgb;
    vec3 emi = texture(temi, tc).rgb;

    vec3 n = normalize(nrm);
    vec3 v = normalize(zucam);

    // licht das ankommt, matt und glanz getrennt
    vec3 dsum = vec3(0.0);
    vec3 ssum = vec3(0.0);

    // ---- licht am bike ----
    vec3 rpl = normalize(zupl);
    float cpl = max(dot(n, rpl), 0.0);
    // vec3 refl = reflect(-rpl, n);
    // float gpl = pow(max(dot(refl, v), 0.0), shin);
    vec3 hpl = normalize(rpl + v);
    float gpl = pow(max(dot(n, hpl), 0.0), shin);
    float dpl = length(zupl);
    float apl = 1.0 / (kpl.x + kpl.y * dpl + kpl.z * dpl * dpl);
    dsum += colpl * cpl * apl;
    ssum += colpl * gpl * apl;

    // ---- scheinwerfer ----
    vec3 rsw = normalize(zusw);
    float csw = max(dot(n, rsw), 0.0);
    vec3 hsw = normalize(rsw + v);
    float gsw = pow(max(dot(n, hsw), 0.0), shin);
    float dsw = length(zusw);
    float asw = 1.0 / (ksw.x + ksw.y * dsw + ksw.z * dsw * dsw);
    float th = dot(-rsw, normalize(dirsw));
    float isw = (th - cos(aussw)) / (cos(innsw) - cos(aussw));
    isw = clamp(isw, 0.0, 1.0);
    dsum += colsw * csw * asw * isw;
    ssum += colsw * gsw * asw * isw;

    // ---- 4.6: nochmal wie oben ----
    vec3 rl2 = normalize(zul2);
    float cl2 = max(dot(n, rl2), 0.0);
    vec3 hl2 = normalize(rl2 + v);
    float gl2 = pow(max(dot(n, hl2), 0.0), shin);
    float dl2 = length(zul2);
    float al2 = 1.0 / (kpl.x + kpl.y * dl2 + kpl.z * dl2 * dl2);
    dsum += coll2 * cl2 * al2;
    ssum += coll2 * gl2 * al2;

    vec3 rl3 = normalize(zul3);
    float cl3 = max(dot(n, rl3), 0.0);
    vec3 hl3 = normalize(rl3 + v);
    float gl3 = pow(max(dot(n, hl3), 0.0), shin);
    float dl3 = length(zul3);
    float al3 = 1.0 / (kpl.x + kpl.y * dl3 + kpl.z * dl3 * dl3);
    dsum += coll3 * cl3 * al3;
    ssum += coll3 * gl3 * al3;

    vec3 rl4 = normalize(zul4);
    float cl4 = max(dot(n, rl4), 0.0);
    vec3 hl4 = normalize(rl4 + v);
    float gl4 = pow(max(dot(n, hl4), 0.0), shin);
    float dl4 = length(zul4);
    float al4 = 1.0 / (kpl.x + kpl.y * dl4 + kpl.z * dl4 * dl4);
    dsum += coll4 * cl4 * al4;
    ssum += coll4 * gl4 * al4;

    vec3 rl5 = normalize(zul5);
    float cl5 = max(dot(n, rl5), 0.0);
    vec3 hl5 = normalize(rl5 + v);
    float gl5 = pow(max(dot(n, hl5), 0.0), shin);
    float dl5 = length(zul5);
    float al5 = 1.0 / (kpl.x + kpl.y * dl5 + kpl.z * dl5 * dl5);
    dsum += coll5 * cl5 * al5;
    ssum += coll5 * gl5 * al5;

    vec3 erg = dif * dsum + spe * ssum;
    // TODO ambient? sieht auch so gut aus
    // erg += dif * 0.1;
    erg += emi * emcol;
    col = vec4(erg, 1.0);
    // col = vec4(n * 0.5 + 0.5, 1.0);   // normalen testen
}
