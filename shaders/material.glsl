struct Material {
    sampler2D emissive;  // M_e
    sampler2D diffuse;   // M_d
    sampler2D specular;  // M_s
    float shininess;     // k
};

uniform Material material;
