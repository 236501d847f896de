package cga.grading.substitute

import cga.grading.capture.CapturedProgram
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC2
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D

/**
 * The sheet's lighting, written for the names of the program [stub], which stands in for one that does not compile.
 *
 * @property isWhole whether all that is sent was understood: then what is missing is missing.
 */
internal class SubstituteShaders private constructor(
    private val stub: CapturedProgram,
    private val sent: Sent,
    private val matrices: Matrices,
    private val vertexText: Declarations,
    private val fragmentText: Declarations,
) {
    private val groups = LightGroups(sent)
    private val tracks = Tracks(sent, matrices)
    private val shared = (vertexText.shared + fragmentText.shared).distinct().joinToString("\n")
    val isWhole: Boolean =
        groups.rest.isEmpty() && groups.lights.none { it.attenuation == null } &&
            sent.matrices.all { it in matrices.used || UniformName(it).says("norm", "inv", "trans") }

    val program: CapturedProgram get() = CapturedProgram(vertex(), fragment(), stub.attributes, stub.outputs, substituted = true)

    private fun vertex(): String {
        val inputs = vertexText.inputs
        val threes = inputs.filter { it.type in PLACES }
        val position = threes.find { !UniformName(it.name).says("norm") } ?: threes.first()
        val normal = (threes - position).let { others -> others.find { UniformName(it.name).says("norm") } ?: others.firstOrNull() }
        val coordinates = inputs.find { it.type == "vec2" }
        val space = matrices.modelView ?: matrices.model ?: "mat4(1.0)"
        return GLSL_HEAD + """
        |${inputs.map { it.text }.distinct().joinToString("\n")}
        |$shared
        |out vec3 cgaPosition, cgaNormal;
        |out vec2 cgaCoordinates;
        |void main() {
        |    vec4 cgaModel = vec4(${position.name}.xyz, 1.0);
        |    mat4 cgaSpace = $space;
        |    cgaPosition = (cgaSpace * cgaModel).xyz;
        |    cgaNormal = inverse(transpose(mat3(cgaSpace))) * ${normal?.let { "${it.name}.xyz" } ?: "vec3(0.0, 1.0, 0.0)"};
        |    cgaCoordinates = ${coordinates?.name ?: "vec2(0.0)"} * ${repeats()};
        |    gl_Position = ${matrices.clip} * cgaModel;
        |}
        """.trimMargin()
    }

    /** How often the textures repeat: the one pair of numbers, or a number called so. */
    private fun repeats(): String {
        val named = sent.names(GL_FLOAT).filter { UniformName(it).says("tc", "tex", "multipl", "repeat", "til", "scale") }
        return (sent.names(GL_FLOAT_VEC2).filterNot { UniformName(it).isCone } + named).firstOrNull() ?: "1.0"
    }

    private fun fragment(): String =
        GLSL_HEAD + """
        |$shared
        |${fragmentText.outputs.map { it.text }.distinct().joinToString("\n")}
        |in vec3 cgaPosition, cgaNormal;
        |in vec2 cgaCoordinates;
        |vec3 cgaDiffuse, cgaSpecular;
        |vec3 cgaShine(vec3 cgaToLight, vec3 cgaK, vec3 cgaColor) {
        |    vec3 cgaN = normalize(cgaNormal);
        |    vec3 cgaL = normalize(cgaToLight);
        |    vec3 cgaH = normalize(cgaL + normalize(${if (matrices.modelView != null) "-cgaPosition" else "cgaNormal"}));
        |    float cgaD = length(cgaToLight);
        |    float cgaPower = pow(max(dot(cgaN, cgaH), 0.0), ${shininess()});
        |    vec3 cgaReflected = cgaDiffuse * max(dot(cgaN, cgaL), 0.0) + cgaSpecular * cgaPower;
        |    return cgaReflected * cgaColor / (cgaK.x + cgaK.y * cgaD + cgaK.z * cgaD * cgaD);
        |}
        |float cgaCone(vec3 fromLight, vec3 direction, float inner, float outer) {
        |    return clamp((dot(normalize(fromLight), normalize(direction)) - outer) / (inner - outer), 0.0, 1.0);
        |}
        |void main() {
        |    cgaDiffuse = ${texel(1)};
        |    cgaSpecular = ${texel(2)};
        |    vec3 cgaSum = ${texel(0)}${groups.tint?.let { " * $it" }.orEmpty()};
        |${groups.lights.joinToString("\n") { "    cgaSum += ${term(it)};" }}
        |    ${fragmentText.outputs.first().name} = vec4(cgaSum, 1.0);
        |}
        """.trimMargin()

    private fun term(light: LightParts): String {
        val toLight = "${inSpace(light.position, tracks.isPlaceInView(light.position), 1)} - cgaPosition"
        val shine = "cgaShine($toLight, ${light.attenuation ?: "vec3(1.0, 0.0, 0.0)"}, ${light.color}.xyz)"
        if (light.direction == null || light.cone == null) return shine
        val direction = inSpace(light.direction, tracks.isDirectionInView(light.direction), 0)
        return "cgaCone(-($toLight), ${tracks.sign(light.direction)}.0 * $direction, ${light.cone.inner}, ${light.cone.outer}) * $shine"
    }

    /** [name] in the space in which is shaded. */
    private fun inSpace(
        name: String,
        isInView: Boolean,
        w: Int,
    ): String {
        if (isInView || matrices.modelView == null || matrices.view == null) return "$name.xyz"
        return "(${matrices.view} * vec4($name.xyz, $w.0)).xyz"
    }

    /** The colour of the map of emission, diffuse and specular, by its name or by its turn. */
    private fun texel(number: Int): String {
        val samplers = sent.names(GL_SAMPLER_2D)
        val named = MAPS.map { words -> samplers.find { name -> words.any { it in name.lowercase() } } }
        val name = named[number] ?: (samplers - named.filterNotNull().toSet()).getOrNull(named.take(number).count { it == null })
        return if (name == null) "vec3(0.0)" else "texture($name, cgaCoordinates).rgb"
    }

    private fun shininess(): String = sent.names(GL_FLOAT).find { UniformName(it).says(EXPONENT) } ?: "60.0"

    companion object {
        private val PLACES = setOf("vec3", "vec4")
        private val MAPS = listOf(listOf("emi", "glow", "leucht"), listOf("diff", "albedo", "base"), listOf("spec", "glanz"))
        private const val GLSL_HEAD = "#version 330 core\n"
        private val EXPONENT = listOf("shin", "gloss", "glanz", "exp", "power", "hard")

        /** Null where it cannot be made out how [stub] would take a vertex to the screen. */
        fun of(
            stub: CapturedProgram,
            sent: Sent,
        ): SubstituteShaders? {
            val vertex = Declarations.of(stub.vertexSource)
            val fragment = Declarations.of(stub.fragmentSource)
            if (vertex.inputs.none { it.type in PLACES } || fragment.outputs.isEmpty()) return null
            return Matrices.of(sent)?.let { SubstituteShaders(stub, sent, it, vertex, fragment) }
        }
    }
}
