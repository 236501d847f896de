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
) {
    private val groups = LightGroups(sent)
    private val tracks = Tracks(sent, matrices)
    private val vertexText = Declarations.of(stub.vertexSource)
    private val fragmentText = Declarations.of(stub.fragmentSource)
    private val shared = (vertexText.shared + fragmentText.shared).distinct().joinToString("\n")
    val isWhole: Boolean =
        groups.rest.isEmpty() && groups.lights.none { it.attenuation == null } &&
            sent.matrices.all { it in matrices.used || UniformName(it).says("norm", "inv", "trans") }

    val program: CapturedProgram get() = CapturedProgram(vertex(), fragment(), stub.attributes, stub.outputs, substituted = true)

    private fun vertex(): String {
        val inputs = vertexText.inputs
        val threes = inputs.filter { it.type == "vec3" || it.type == "vec4" }
        val normal = threes.find { UniformName(it.name).says("norm") } ?: threes.getOrNull(1)
        val position = threes.find { it != normal } ?: inputs.first()
        val coordinates = inputs.find { it.type == "vec2" }
        val space = matrices.modelView ?: matrices.model ?: "mat4(1.0)"
        return """
            |#version 330 core
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
            |
        """.trimMargin()
    }

    /** How often the textures repeat: the one pair of numbers, or a number called so. */
    private fun repeats(): String {
        val cones = groups.lights.flatMap { listOfNotNull(it.inner, it.outer) }
        return (sent.names(GL_FLOAT_VEC2) + sent.names(GL_FLOAT).filter { UniformName(it).says("tc", "tex", "multipl", "repeat", "til", "scale") })
            .firstOrNull { name -> cones.none { name in it } } ?: "1.0"
    }

    private fun fragment(): String =
        """
        |#version 330 core
        |$shared
        |${fragmentText.outputs.map { it.text }.distinct().joinToString("\n")}
        |in vec3 cgaPosition, cgaNormal;
        |in vec2 cgaCoordinates;
        |vec3 cgaDiffuse, cgaSpecular;
        |vec3 cgaShine(vec3 toLight, vec3 k, vec3 lightColor) {
        |    vec3 n = normalize(cgaNormal);
        |    vec3 l = normalize(toLight);
        |    vec3 h = normalize(l + normalize(${if (matrices.modelView != null) "-cgaPosition" else "cgaNormal"}));
        |    float d = length(toLight);
        |    return (cgaDiffuse * max(dot(n, l), 0.0) + cgaSpecular * pow(max(dot(n, h), 0.0), ${shininess()})) * lightColor / (k.x + k.y * d + k.z * d * d);
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
        |
        """.trimMargin()

    private fun term(light: LightParts): String {
        val toLight = "${inSpace(light.position, tracks.isPlaceInView(light.position), 1)} - cgaPosition"
        val shine = "cgaShine($toLight, ${light.attenuation ?: "vec3(1.0, 0.0, 0.0)"}, ${light.color}.xyz)"
        if (light.direction == null || light.outer == null) return shine
        val direction = inSpace(light.direction, tracks.isDirectionInView(light.direction), 0)
        // An edge where only one angle is sent.
        val inner = light.inner ?: "(${light.outer} + 1e-3)"
        return "cgaCone(-($toLight), ${tracks.sign(light.direction)}.0 * $direction, $inner, ${light.outer}) * $shine"
    }

    /** [name] in the space in which is shaded. */
    private fun inSpace(
        name: String,
        isInView: Boolean,
        w: Int,
    ): String = if (isInView || matrices.modelView == null || matrices.view == null) "$name.xyz" else "(${matrices.view} * vec4($name.xyz, $w.0)).xyz"

    /** The colour of the map of emission, diffuse and specular, by its name or by its turn. */
    private fun texel(number: Int): String {
        val samplers = sent.names(GL_SAMPLER_2D)
        val words = listOf(listOf("emi", "glow", "leucht"), listOf("diff", "albedo", "base"), listOf("spec", "glanz"))
        val named = words.map { all -> samplers.find { UniformName(it).says(*all.toTypedArray()) || all.any { word -> word in it.lowercase() } } }
        val name = named[number] ?: (samplers - named.filterNotNull().toSet()).getOrNull(named.take(number).count { it == null })
        return if (name == null) "vec3(0.0)" else "texture($name, cgaCoordinates).rgb"
    }

    private fun shininess(): String = sent.names(GL_FLOAT).find { UniformName(it).says("shin", "gloss", "glanz", "expon", "exp", "power", "hard") } ?: "60.0"

    companion object {
        /** Null where it cannot be made out how [stub] would take a vertex to the screen. */
        fun of(
            stub: CapturedProgram,
            sent: Sent,
        ): SubstituteShaders? = Matrices.of(sent)?.let { SubstituteShaders(stub, sent, it) }
    }
}
