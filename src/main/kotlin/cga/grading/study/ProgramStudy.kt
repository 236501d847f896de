package cga.grading.study

import cga.framework.InputError
import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.EventKind
import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_FLOAT_MAT4
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D
import kotlin.random.Random

/**
 * Everything that was found out about one program, from one of its draws.
 *
 * @param exponent what the picture was raised to before measuring: 1 without gamma, 2.2 undoes one, 1/2.2 one in the wrong direction.
 * @param normalsMoved whether the shader adds something to the normals.
 * @param isAwake whether uniforms that were never sent had to be given values for any light to shine.
 * @param hidesLights whether something shines that none of the [colors] is the colour of.
 * @param files names of the files that samplers read from, as far as known, over all draws.
 * @param lights that shine somewhere; [silent] that do not and could.
 */
internal class ProgramStudy(
    val number: Int,
    val box: BlackBox,
    val formula: GeometryFormula,
    val colors: ColorSlots,
    val roles: TextureRoles?,
    val exponent: Double,
    val lights: List<LightModel>,
    val emission: EmissionStudy,
    val silent: List<SilentLight>,
    val normalsMoved: Boolean,
    val isAwake: Boolean,
    val neverConed: List<LightModel>,
    val hidesLights: Boolean,
    val files: Map<String, Set<String>> = emptyMap(),
    private val sent: Map<String, List<FloatArray>> = emptyMap(),
) {
    /** The lights that are not black in all draws: what those would do nobody sees. */
    val shining: List<LightModel> by lazy { lights.filter(::everShines) }

    private fun everShines(light: LightModel): Boolean =
        sent[light.probe.slot.name]?.any { value -> value.take(3).any { it != 0f } } ?: true

    /** All numbers of vectors and scalars that were sent with the draw, none made up. */
    fun numbersSent(): List<Double> =
        box.program.uniforms
            .filter { it.components <= 4 && !it.isSampler }
            .flatMap { (sent[it.name]?.lastOrNull() ?: box.values[it.name] ?: FloatArray(0)).toList() }
            .map { it.toDouble() }

    companion object {
        /** Studies program [number] of [capture] by [draw]. Throws [InputError] when it cannot be probed. */
        fun of(
            rig: ProbeRig,
            program: ProbeProgram,
            capture: Capture,
            number: Int,
            draw: CapturedDraw,
        ): ProgramStudy {
            val (box, formula) = box(rig, program, capture, number, draw)
            val surface = surface(box, formula, DrawVertices(capture, draw))
            val (decoded, plain) = colors(box, surface)
            val search = LightSearch(decoded, surface)
            val samples = LightSearch(decoded, surface).samples(LightSearch.FEW_DIRECTIONS)
            val colors = if (program.deep.isEmpty()) plain else HiddenLights.added(decoded, plain, samples)
            val usual = Lit.of(decoded, colors, search)
            // What a shader adds to normals (the translation of a 4 × 4 matrix) is nothing beside long ones.
            val long = if (usual.roles != null &&
                usual.roles.diffuse == null
            ) {
                Lit.of(decoded.withNormalLength(LONG), colors, search)
            } else {
                usual
            }
            val lit = if (long.roles?.diffuse != null) long else usual
            val roles = lit.roles
            val lights = if (roles == null) emptyList() else lit.probes.mapNotNull { LightStudy(search, roles).of(it) }
            val emission = EmissionStudy.of(decoded, colors, roles)
            return ProgramStudy(
                number, decoded, formula, colors, roles, decoded.exponent, lights, emission,
                SilentLights.of(
                    decoded,
                    colors.silent,
                    surface,
                ),
                lit !== usual,
                colors.lights.isNotEmpty() && isAwake(
                    box,
                    decoded,
                ),
                neverConed(decoded, colors, surface, roles, lights),
                HiddenLights.areThere(decoded, colors, samples), files(capture, number), sentValues(capture, number, draw),
            )
        }

        /** The black box of [draw]. */
        fun box(
            rig: ProbeRig,
            program: ProbeProgram,
            capture: Capture,
            number: Int,
            draw: CapturedDraw,
        ): Pair<BlackBox, GeometryFormula> {
            val active = capture.programs[number].attributes.values
            val values = program.constants + draw.uniforms.associate { it.name to it.numbers }
            val formula =
                GeometryFormula.of(rig, program, active, values)
                    ?: throw InputError("no vertex attribute moves the vertices of program $number")
            val matrices = program.uniforms.filter { it.type == GL_FLOAT_MAT4 && it.name in values }.map { it.name }
            val spaces =
                Spaces.of(formula, matrices, values) ?: throw InputError("what program $number does with its matrices is not understood")
            val sizes = draw.attributes.associate { it.location to it.size }
            val others = active - formula.positionLocation
            val normal = others.filter { sizes[it] == 3 }.let { threes ->
                threes.singleOrNull()
                    ?: threes.firstOrNull { isNormal(DrawVertices(capture, draw), it) }
            }
            return BlackBox(rig, program, formula.positionLocation, normal, others.filter { it != normal }, spaces, values) to formula
        }

        private fun files(
            capture: Capture,
            number: Int,
        ): Map<String, Set<String>> {
            val events = capture.events.filter { it.kind == EventKind.TEXTURE_FILE }
            val names = events.associate { it.text.substringBefore(' ').toIntOrNull() to it.text.substringAfter(' ') }
            val draws = capture.frames.flatMap { it.steps }.filterIsInstance<CapturedDraw>().filter { it.program == number }
            val read = draws.flatMap { draw ->
                draw.uniforms.filter { it.type == GL_SAMPLER_2D }.map { it.name to names[draw.textures[it.numbers[0].toInt()]] }
            }
            return read.groupBy({ it.first }, { it.second }).mapValues { it.value.filterNotNull().toSet() }.filterValues { it.isNotEmpty() }
        }

        /** Values of each uniform over all draws of program [number], those of [draw] last. */
        private fun sentValues(
            capture: Capture,
            number: Int,
            draw: CapturedDraw,
        ): Map<String, List<FloatArray>> {
            val draws = capture.frames.flatMap { it.steps }.filterIsInstance<CapturedDraw>().filter { it.program == number }
            return (draws + draw).flatMap { it.uniforms }.groupBy({ it.name }, { it.numbers })
        }

        private fun isNormal(
            vertices: DrawVertices,
            location: Int,
        ): Boolean =
            vertices.distinct.take(20).all { v ->
                val n = vertices.read(location, v) ?: return false
                Vector3d(n[0], n[1], n[2]).length() in 0.98..1.02
            }

        /** Points on the surface of the draw and a little off it, in view space. */
        private fun surface(
            box: BlackBox,
            formula: GeometryFormula,
            vertices: DrawVertices,
        ): List<Vector3d> {
            val random = Random(11)
            val distinct = vertices.distinct
            if (distinct.isEmpty()) return emptyList()
            return List(SURFACE) {
                val weights = List(3) { random.nextDouble() }
                val p = Vector3d()
                for (w in weights) {
                    val v = vertices.read(formula.positionLocation, distinct[random.nextInt(distinct.size)]) ?: continue
                    p.fma(w / weights.sum(), Vector3d(v[0], v[1], v[2]))
                }
                box.spaces.modelView.transformPosition(p).add(Directions.random(random).mul(0.5))
            }
        }

        /** Those of [lights] that shine evenly and would not if numbers that are 0 were something else. */
        private fun neverConed(
            box: BlackBox,
            colors: ColorSlots,
            surface: List<Vector3d>,
            roles: TextureRoles?,
            lights: List<LightModel>,
        ): List<LightModel> {
            val zeros = SilentLights.zeros(box)
            if (roles == null || roles.isShared || zeros.none { it.components <= 2 }) return emptyList()
            val awake = SilentLights.awake(box, zeros)
            val study = LightStudy(LightSearch(awake, surface), roles)
            return lights.filter { it.cone == null }.filter { study.of(LightProbe(awake, it.probe.slot, colors))?.cone != null }
        }

        private fun isAwake(
            box: BlackBox,
            studied: BlackBox,
        ) = SilentLights.zeros(box).any { studied.values[it.name]?.contentEquals(box.values[it.name]) == false }

        /** The colours of [box], with the gamma that has to be undone first. */
        private fun colors(
            box: BlackBox,
            surface: List<Vector3d>,
        ): Pair<BlackBox, ColorSlots> {
            val search = LightSearch(box, surface)
            val few = search.samples(LightSearch.FEW_DIRECTIONS)
            val many = search.samples(LightSearch.MANY_DIRECTIONS)
            val plain = ColorSlots.of(box, few, many)
            if (plain.lights.isNotEmpty()) return box to plain
            for (exponent in EXPONENTS) {
                val decoded = box.decodedBy(exponent)
                val colors = ColorSlots.of(decoded, few, many)
                if (colors.lights.isNotEmpty()) return decoded to colors
            }
            // One light that divides by what was never sent can make all of the picture NaN.
            val awake = SilentLights.awake(box, SilentLights.zeros(box))
            val colors = ColorSlots.of(awake, few, many)
            return if (colors.lights.isEmpty()) box to plain else awake to colors
        }

        private const val SURFACE = 240
        private const val LONG = 1048576.0
        private val EXPONENTS = listOf(2.2, 1 / 2.2, 2.0, 0.5, 1.8, 2.4)
    }
}
