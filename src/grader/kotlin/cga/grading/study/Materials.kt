package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedFrame
import org.joml.Matrix4d
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import org.lwjgl.opengl.GL33C.GL_TRIANGLES
import kotlin.math.abs

/**
 * One draw as a surface with a material, in the terms of the lighting model.
 *
 * @param vertices eight floats each: position, texture coordinates as the textures are read with, normal; [indices] three a triangle.
 * @param model model space → world space.
 * @param tint factor of the emission; null where the submission has none.
 * @param ambient L_a as the submission sends it, null where it sends none.
 * @param emission number of the captured texture, null where nothing glows; likewise [diffuse] and [specular].
 * @param gamma what the shader's picture has to be raised to for light to add up: 1 without gamma.
 * @param powers what the colours of a texture are raised to when they are read, by its number: 1 for those that are not in it.
 */
internal class Surface(
    val vertices: FloatArray,
    val indices: IntArray,
    val model: Matrix4dc,
    val tint: Vector3dc?,
    val ambient: Vector3dc?,
    val emission: Int?,
    val diffuse: Int?,
    val specular: Int?,
    val exponent: Double,
    val gamma: Double,
    val powers: Map<Int, Double> = emptyMap(),
)

/** The materials of a capture's draws, by what [studies] found out about its programs. Needs a current context. */
internal class Materials(
    private val rig: ProbeRig,
    private val capture: Capture,
    private val studies: Map<Int, ProgramStudy>,
) {
    private val coordinates = HashMap<List<Any>, TexCoords?>()

    /** The sampler that reads the emission in program [number]; null where it is unknown or reads more than that. */
    fun emissionSampler(
        number: Int,
    ): String? = studies[number]?.roles?.takeUnless { it.multiplied }?.let { roles ->
        roles.emission.takeIf {
            it !=
                roles.diffuse &&
                it != roles.specular
        }
    }

    /** The uniform of program [number] that is ambient light. */
    fun ambientUniform(number: Int): String? = studies[number]?.emission?.ambient?.name

    /** The surfaces of [frame], seen through [view], without what no light falls on; null where one of them is not understood. */
    fun of(
        frame: CapturedFrame,
        view: Matrix4dc,
    ): List<Surface>? =
        frame.draws
            .filter { studies[it.program]?.isOfScene != false }
            .map { surface(it, view) ?: return null }

    private fun surface(
        draw: CapturedDraw,
        view: Matrix4dc,
    ): Surface? {
        val study = studies[draw.program] ?: return null
        val roles = study.roles ?: return null
        val diffuse = texture(draw, roles.diffuse) ?: return null
        if (draw.mode != GL_TRIANGLES || draw.instances != 1) return null
        val values = study.box.program.values(draw)
        val spaces = Spaces.of(study.formula, study.box.program.matrices.filter { it in values }, values) ?: return null
        val normal = normal(draw, study.formula.positionLocation) ?: return null
        val coords = texCoords(draw, study, lit(draw.program, values)) ?: return null
        val mesh = mesh(draw, study.formula.positionLocation, normal, coords) ?: return null
        val emission = roles.emission ?: rest(study, roles)
        val powers = roles.powers + coords.read
        return Surface(
            vertices = mesh.first,
            indices = mesh.second,
            model = spaces.model ?: view.invert(Matrix4d()).mul(spaces.modelView),
            tint = study.emission.tint?.let { color(values[it.name]) },
            ambient = study.emission.ambient?.let { color(values[it.name]) },
            emission = texture(draw, emission),
            diffuse = diffuse,
            specular = texture(draw, roles.specular),
            exponent = exponent(study, values),
            gamma = study.exponent,
            powers = powers.mapNotNull { (sampler, power) -> texture(draw, sampler)?.let { it to power } }.toMap(),
        )
    }

    /** The sampler that nothing was found for: with an emission that is missing, its texture. */
    private fun rest(
        study: ProgramStudy,
        roles: TextureRoles,
    ): String? = study.box.program.samplers.map { it.name }.filter { it != roles.diffuse && it != roles.specular }.singleOrNull()

    private fun texture(
        draw: CapturedDraw,
        sampler: String?,
    ): Int? = draw.uniforms.find { it.name == sampler }?.let { draw.textures[it.numbers[0].toInt()] }

    private fun color(numbers: FloatArray?): Vector3d? = numbers
        ?.takeIf {
            it.size >= 3
        }?.let { Vector3d(it[0].toDouble(), it[1].toDouble(), it[2].toDouble()) }

    private fun exponent(
        study: ProgramStudy,
        values: Map<String, FloatArray>,
    ): Double {
        val highlight = study.lights.firstNotNullOfOrNull { it.highlight }
        val sent = highlight?.exponentSlot?.let { values[it.name]?.getOrNull(it.component) }
        return sent?.toDouble() ?: highlight?.fit?.exponent ?: USUAL_EXPONENT
    }

    /** The other vector of three numbers; of several the one that has unit length. */
    private fun normal(
        draw: CapturedDraw,
        position: Int,
    ): Int? {
        val active = capture.programs[draw.program].attributes.values
        val threes = draw.attributes.filter { it.size == 3 && it.location != position && it.location in active }.map { it.location }
        return threes.singleOrNull() ?: threes.firstOrNull { isUnit(DrawVertices(capture, draw), it) }
    }

    private fun isUnit(
        vertices: DrawVertices,
        location: Int,
    ): Boolean =
        vertices.distinct.take(SOME).all { vertex ->
            val n = vertices.read(location, vertex) ?: return false
            abs(Vector3d(n[0], n[1], n[2]).length() - 1) < NEAR
        }

    private fun mesh(
        draw: CapturedDraw,
        position: Int,
        normal: Int,
        coords: TexCoords,
    ): Pair<FloatArray, IntArray>? {
        val read = DrawVertices(capture, draw)
        val numbers = read.distinct.withIndex().associate { it.value to it.index }
        val indices = IntArray(read.order.size / 3 * 3) { numbers.getValue(read.order[it]) }
        val vertices = FloatArray(FLOATS * numbers.size)
        for ((vertex, number) in numbers) {
            val p = read.read(position, vertex) ?: return null
            val t = coords.location?.let { read.read(it, vertex) ?: return null } ?: DoubleArray(2)
            val n = read.read(normal, vertex) ?: return null
            for (axis in 0..2) vertices[FLOATS * number + axis] = p[axis].toFloat()
            for (axis in 0..1) vertices[FLOATS * number + 3 + axis] = coords.of(t, axis).toFloat()
            for (axis in 0..2) vertices[FLOATS * number + 5 + axis] = n[axis].toFloat()
        }
        return vertices to indices
    }

    /** [values] with every colour white, and with what the picture cannot be without, so that all that is textured shows. */
    private fun lit(
        program: Int,
        values: Map<String, FloatArray>,
    ): Map<String, FloatArray> {
        val study = studies.getValue(program)
        val colors = study.colors
        return values + study.box.values.filterKeys(study.deadly::contains) +
            Setting().withColors(colors.flats + colors.factors + colors.lights, 1.0).values
    }

    private fun texCoords(
        draw: CapturedDraw,
        study: ProgramStudy,
        values: Map<String, FloatArray>,
    ): TexCoords? {
        val position = study.formula.positionLocation
        val pairs = draw.attributes.filter { it.size == 2 && it.location != position }.map { it.location }
        // Vectors of two numbers and single ones are all that texture coordinates are scaled by.
        val scales = draw.uniforms.filter { it.numbers.size <= 2 }.flatMap { it.numbers.toList() }
        val roles = study.roles
        // What glows shows everywhere, what is lit where light falls, and the product of both where light falls on what glows.
        val glowing = listOfNotNull(roles?.emission)
        val lit = listOfNotNull(roles?.diffuse)
        val shown = if (roles?.multiplied == true) listOf(glowing + lit) else listOf(glowing, lit)
        return coordinates.getOrPut(listOf(draw.program, pairs, scales)) {
            val reading = Reading(rig, capture.programs[draw.program], draw.attributes.map { it.location }, values, study.exponent)
            shown.filter { it.isNotEmpty() }.firstNotNullOfOrNull {
                TexCoords.of(
                    reading,
                    pairs,
                    it.toSet(),
                    roles?.powers?.get(it.last()),
                )
            }
        }
    }

    private companion object {
        const val FLOATS = 8
        const val SOME = 20
        const val NEAR = 0.02
        const val USUAL_EXPONENT = 60.0
    }
}
