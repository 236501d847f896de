package cga.grading.study

/** Shaders in the manner of the course's submissions, as text to be edited. */
internal object CourseShaders {
    val VERTEX =
        """
        #version 330 core
        layout(location = 0) in vec3 position;
        layout(location = 1) in vec2 texCoord;
        layout(location = 2) in vec3 normal;

        uniform mat4 model_matrix;
        uniform mat4 view_matrix;
        uniform mat4 projection_matrix;
        uniform vec2 tcMultiplier;

        uniform vec3 pointLightPos;
        uniform vec3 cornerLightPos;
        uniform vec3 spotLightPos;

        out struct VertexData {
            vec3 normal;
            vec2 texCoord;
            vec3 toCamera;
            vec3 toPointLight;
            vec3 toCornerLight;
            vec3 toSpotLight;
        } vertexData;

        void main() {
            mat4 modelView = view_matrix * model_matrix;
            vec4 pos = modelView * vec4(position, 1.0);
            gl_Position = projection_matrix * pos;
            vertexData.texCoord = texCoord * tcMultiplier;
            vertexData.normal = (inverse(transpose(modelView)) * vec4(normal, 0.0)).xyz;
            vertexData.toCamera = -pos.xyz;
            vertexData.toPointLight = (view_matrix * vec4(pointLightPos, 1.0)).xyz - pos.xyz;
            vertexData.toCornerLight = (view_matrix * vec4(cornerLightPos, 1.0)).xyz - pos.xyz;
            vertexData.toSpotLight = (view_matrix * vec4(spotLightPos, 1.0)).xyz - pos.xyz;
        }
        """.trimIndent()

    val FRAGMENT =
        """
        #version 330 core
        in struct VertexData {
            vec3 normal;
            vec2 texCoord;
            vec3 toCamera;
            vec3 toPointLight;
            vec3 toCornerLight;
            vec3 toSpotLight;
        } vertexData;

        uniform sampler2D emit;
        uniform sampler2D diff;
        uniform sampler2D spec;
        uniform float shininess;
        uniform vec3 sceneColour;

        uniform vec3 pointLightColor;
        uniform vec3 pointLightAttenuation;
        uniform vec3 cornerLightColor;
        uniform vec3 cornerLightAttenuation;
        uniform vec3 spotLightColor;
        uniform vec3 spotLightAttenuation;
        uniform vec3 spotLightDirection;
        uniform float spotInner;
        uniform float spotOuter;

        out vec4 color;

        float attenuate(float d, vec3 k) {
            return 1.0 / (k.x + k.y * d + k.z * d * d);
        }

        vec3 shade(vec3 n, vec3 l, vec3 v, vec3 diffuse, vec3 specular) {
            float cosAlpha = max(dot(n, l), 0.0);
            vec3 h = normalize(l + v);
            float cosBeta = max(dot(n, h), 0.0);
            return diffuse * cosAlpha + specular * pow(cosBeta, shininess);
        }

        float cone(vec3 l) {
            float theta = dot(-l, normalize(spotLightDirection));
            float inner = cos(spotInner);
            float outer = cos(spotOuter);
            return clamp((theta - outer) / (inner - outer), 0.0, 1.0);
        }

        void main() {
            vec3 n = normalize(vertexData.normal);
            vec3 v = normalize(vertexData.toCamera);
            vec3 lp = normalize(vertexData.toPointLight);
            vec3 lc = normalize(vertexData.toCornerLight);
            vec3 ls = normalize(vertexData.toSpotLight);
            float dp = length(vertexData.toPointLight);
            float dc = length(vertexData.toCornerLight);
            float ds = length(vertexData.toSpotLight);
            vec3 emission = texture(emit, vertexData.texCoord).rgb * sceneColour;
            vec3 diffuse = texture(diff, vertexData.texCoord).rgb;
            vec3 specular = texture(spec, vertexData.texCoord).rgb;

            vec3 result = emission;
            result += shade(n, lp, v, diffuse, specular) * pointLightColor * attenuate(dp, pointLightAttenuation);
            result += shade(n, lc, v, diffuse, specular) * cornerLightColor * attenuate(dc, cornerLightAttenuation);
            result += shade(n, ls, v, diffuse, specular) * spotLightColor * attenuate(ds, spotLightAttenuation) * cone(ls);
            color = vec4(result, 1.0);
        }
        """.trimIndent()
}

/** This text with [old] replaced by [new]; a text without [old] is a broken test. */
internal fun String.edited(
    old: String,
    new: String,
): String {
    check(old in this) { "the shader has no \"$old\"" }
    return replace(old, new)
}
