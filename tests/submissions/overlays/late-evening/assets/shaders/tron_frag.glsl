#version 330 core
#define LAMPEN 5

in vec2 fTex;
in vec3 fNorm;
in vec3 fToCam;
in vec3 fToMotor;
in vec3 fToFront;
in vec3 fToLampe[LAMPEN];

uniform sampler2D matDiff;
uniform sampler2D matSpec;
uniform sampler2D matEmit;
uniform float matShine;
uniform vec3 emitCol;

uniform vec3 colMotor;
uniform vec3 attMotor;

uniform vec3 colFront;
uniform vec3 attFront;
uniform vec3 dirFront;
uniform float cosGammaFront;
uniform float cosPhiFront;

uniform vec3 colLampe[LAMPEN];
uniform vec3 attLampe[LAMPEN];

out vec4 fragColor;

float daempfung(vec3 toLight, vec3 k){
    float d = length(toLight);
    return 1.0 / (k.x + k.y * d + k.z * d * d);
}

float kegel(vec3 toLight){
    float cosTheta = dot(normalize(dirFront), normalize(-toLight));
    float I = (cosTheta - cosPhiFront) / (cosGammaFront - cosPhiFront);
    return clamp(I, 0.0, 1.0);
}

//sammelt das Licht, die Texturen kommen erst am Ende dazu
void beleuchte(vec3 toLight, vec3 col, vec3 N, vec3 V, inout vec3 sumDiff, inout vec3 sumSpec){
    vec3 L = normalize(toLight);
    float cosa = dot(N, L);
    if(cosa > 0.0){
        sumDiff += cosa * col;
        vec3 H = normalize(L + V);
        float cosb = max(0.0, dot(H, N));
        sumSpec += pow(cosb, matShine) * col;
    }
}

void main(){
    vec3 N = normalize(fNorm);
    vec3 V = normalize(fToCam);
    vec3 sumDiff = vec3(0.03);
    vec3 sumSpec = vec3(0.0);

    //Punktlicht am Motorrad
    vec3 colM = colMotor * daempfung(fToMotor, attMotor);
    beleuchte(fToMotor, colM, N, V, sumDiff, sumSpec);

    //Scheinwerfer
    vec3 colF = colFront * daempfung(fToFront, attFront) * kegel(fToFront);
    beleuchte(fToFront, colF, N, V, sumDiff, sumSpec);

    //Lampen auf der Plane
    for(int i = 0; i < LAMPEN; i++){
        vec3 colL = colLampe[i] * daempfung(fToLampe[i], attLampe[i]);
        beleuchte(fToLampe[i], colL, N, V, sumDiff, sumSpec);
    }

    vec3 ausgabe = texture(matEmit, fTex).rgb * emitCol;
    ausgabe += texture(matDiff, fTex).rgb * sumDiff;
    ausgabe += texture(matSpec, fTex).rgb * sumSpec;
    fragColor = vec4(ausgabe, 1.0);
}
