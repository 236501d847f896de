#version 330 core

//#define PHONG
//#define EX 32.0
#define ATT(t, k) (1.0 / (k.x + k.y * length(t) + k.z * dot(t, t)))
#ifdef PHONG
// 4.2
#define SP(l) pow(max(dot(v, reflect(-l, n)), 0.0), ex)
#else
// 4.7
#define SP(l) pow(max(dot(n, normalize(l + v)), 0.0), ex)
#endif

in vec2 u;
in vec3 no;
in vec3 tc;
in vec3 tl1;
in vec3 tl2;
in vec3 tl3;
in vec3 tl4;
in vec3 tl5;
in vec3 tl6;

uniform sampler2D xd;
uniform sampler2D xs;
uniform sampler2D xe;
uniform float ex;
uniform vec3 ec;

uniform vec3 plc;
uniform vec3 plk;
uniform vec3 slc;
uniform vec3 slk;
uniform vec3 sld;
uniform vec2 slw; // innen, aussen
uniform vec3 e1c;
uniform vec3 e1k;
uniform vec3 e2c;
uniform vec3 e2k;
uniform vec3 e3c;
uniform vec3 e3k;
uniform vec3 e4c;
uniform vec3 e4k;

out vec4 color;

void main() {
    vec3 n = normalize(no);
    vec3 v = normalize(tc);
    vec3 d = vec3(0.0);
    vec3 s = vec3(0.0);

    // pl
    vec3 l1 = normalize(tl1);
    vec3 c1 = plc * ATT(tl1, plk);
    d += max(dot(n, l1), 0.0) * c1;
    s += SP(l1) * c1;

    // sl
    vec3 l2 = normalize(tl2);
    vec3 c2 = slc * ATT(tl2, slk);
    float th = dot(-l2, normalize(sld));
    //float i = th > cos(slw.y) ? 1.0 : 0.0;
    float i = clamp((th - cos(slw.y)) / (cos(slw.x) - cos(slw.y)), 0.0, 1.0);
    d += max(dot(n, l2), 0.0) * c2 * i;
    s += SP(l2) * c2 * i;

    // ecken
    vec3 l3 = normalize(tl3);
    vec3 c3 = e1c * ATT(tl3, e1k);
    d += max(dot(n, l3), 0.0) * c3;
    s += SP(l3) * c3;

    vec3 l4 = normalize(tl4);
    vec3 c4 = e2c * ATT(tl4, e2k);
    d += max(dot(n, l4), 0.0) * c4;
    s += SP(l4) * c4;

    vec3 l5 = normalize(tl5);
    vec3 c5 = e3c * ATT(tl5, e3k);
    d += max(dot(n, l5), 0.0) * c5;
    s += SP(l5) * c5;

    vec3 l6 = normalize(tl6);
    vec3 c6 = e4c * ATT(tl6, e4k);
    d += max(dot(n, l6), 0.0) * c6;
    s += SP(l6) * c6;

    //color = vec4(d + s, 1.0);
    color = vec4(texture(xe, u).rgb * ec + texture(xd, u).rgb * d + texture(xs, u).rgb * s, 1.0);
}
