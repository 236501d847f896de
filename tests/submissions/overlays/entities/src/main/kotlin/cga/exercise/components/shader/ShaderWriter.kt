package cga.exercise.components.shader

/** Puts the shaders together for the lights that the scene has; each has uniforms of its own with its name at the end. */
class ShaderWriter(private val points: List<String>, private val spots: List<String>) {
    private val all = points + spots

    fun vertexShader() = listOf(
        VERSION,
        ATTRIBUTES,
        each(all) { "uniform vec3 position_$it;" },
        each(all) { "out vec3 to_$it;" },
        """
        void main() {
            vec4 p = modelView * vec4(a_position, 1.0);
            gl_Position = projection * p;
            uv = a_uv * tiling;
            normal = normalMatrix * a_normal;
            toCamera = -p.xyz;
        """,
        each(all) { "to_$it = position_$it - p.xyz;" },
        "}"
    ).join()

    fun fragmentShader() = listOf(
        VERSION,
        SURFACE,
        each(all) { "in vec3 to_$it;\nuniform vec3 color_$it;\nuniform vec3 k_$it;" },
        each(spots) { "uniform vec3 direction_$it;\nuniform vec2 cone_$it;" },
        FUNCTIONS,
        """
        void main() {
            n = normalize(normal);
            v = normalize(toCamera);
            diffuse = texture(map_diffuse, uv).rgb;
            specular = texture(map_specular, uv).rgb;
            vec3 c = emission * texture(map_emissive, uv).rgb;
        """,
        each(points) { "c += reflected(to_$it) * color_$it * fading(to_$it, k_$it);" },
        each(spots) { "c += reflected(to_$it) * color_$it * fading(to_$it, k_$it) * inCone(to_$it, direction_$it, cone_$it);" },
        "fragment = vec4(c, 1.0);",
        "}"
    ).join()

    private fun each(names: List<String>, line: (String) -> String) = names.joinToString("\n", transform = line)

    private fun List<String>.join() = joinToString("\n") { it.trimIndent() } + "\n"

    private companion object {
        const val VERSION = "#version 330 core"

        const val ATTRIBUTES = """
            layout(location = 0) in vec3 a_position;
            layout(location = 1) in vec2 a_uv;
            layout(location = 2) in vec3 a_normal;
            uniform mat4 modelView;
            uniform mat4 projection;
            uniform mat3 normalMatrix;
            uniform vec2 tiling;
            out vec2 uv;
            out vec3 normal;
            out vec3 toCamera;
        """

        const val SURFACE = """
            in vec2 uv;
            in vec3 normal;
            in vec3 toCamera;
            uniform sampler2D map_diffuse;
            uniform sampler2D map_emissive;
            uniform sampler2D map_specular;
            uniform float shininess;
            uniform vec3 emission;
            out vec4 fragment;
            vec3 n, v, diffuse, specular;
        """

        const val FUNCTIONS = """
            vec3 reflected(vec3 toLight) {
                vec3 l = normalize(toLight);
                vec3 h = normalize(l + v);
                float a = max(0.0, dot(n, l));
                float b = max(0.0, dot(n, h));
                return a * diffuse + pow(b, shininess) * specular;
            }

            float fading(vec3 toLight, vec3 k) {
                float d = length(toLight);
                return 1.0 / (k[0] + d * (k[1] + d * k[2]));
            }

            float inCone(vec3 toLight, vec3 direction, vec2 cone) {
                float theta = acos(clamp(dot(normalize(-toLight), direction), -1.0, 1.0));
                vec3 cosines = cos(vec3(theta, cone));
                return clamp((cosines.x - cosines.z) / (cosines.y - cosines.z), 0.0, 1.0);
            }
        """
    }
}
