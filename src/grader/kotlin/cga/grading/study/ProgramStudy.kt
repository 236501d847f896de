package cga.grading.study

import cga.framework.InputError
import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import org.joml.Vector3d
import org.joml.Vector3dc
import org.lwjgl.opengl.GL33C.GL_FLOAT_MAT4
import kotlin.random.Random

/**
 * Everything that was found out about one program, from one of its draws.
 *
 * @param exponent what the picture was raised to before measuring: 1 without gamma, 2.2 undoes one, 1/2.2 one in the wrong direction.
 * @param normalsMoved whether the shader adds something to the normals.
 * @param isAwake whether uniforms that were never sent had to be given values for any light to shine.
 * @param hidesLights whether something shines that none of the [colors] is the colour of.
 * @param samplers what they read, over all draws.
 * @param deadly uniforms that were never sent and leave no number of the picture.
 * @param isOverlapping whether two vertex attributes of a mesh are in the same bytes.
 * @param isGlowEncoded whether what glows is encoded as the lights are, and not added to them afterwards.
 * @param lent names of lights in whose colour another one shines too; only where no light has a cone.
 * @param surface points on what was drawn and near it, in view space.
 * @param elsewhere another object's draw, if there is one.
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
    val coneless: ConelessLights,
    val hidesLights: Boolean,
    val samplers: SamplerFacts = SamplerFacts(),
    private val sent: Map<String, List<FloatArray>> = emptyMap(),
    val deadly: Set<String> = emptySet(),
    val isGlowEncoded: Boolean = true,
    val isOverlapping: Boolean = false,
    val lent: Set<String> = emptySet(),
    val surface: List<Vector3d> = emptyList(),
    val elsewhere: BlackBox? = null,
) {
    /** The lights that are not black in all draws: what those would do nobody sees. */
    val shining: List<LightModel> by lazy { lights.filter(::everShines) }

    /** Whether it has what the shaders of the scene have: lights or textures. */
    val isOfScene: Boolean get() = colors.lights.isNotEmpty() || box.program.samplers.isNotEmpty()

    private fun everShines(light: LightModel): Boolean =
        sent[light.probe.slot.name]?.any { value -> value.take(3).any { it != 0f } } ?: true

    /** The other light whose distance [light] fades with, its own being somewhere else; null where it does not. */
    fun distanceOf(light: LightModel): LightModel? {
        val from = light.attenuation?.from ?: return null
        val sound = lights.filter { it !== light && it.placement != null && it.attenuation?.from == null && !it.otherDirection }
        // Two lights at one place: then it is the direction that is the other's.
        if (sound.any { isAt(it, light.placement?.view ?: from) }) return null
        return sound.firstOrNull { isAt(it, from) }
    }

    /** The other light whose directions [light] takes while its distances are its own; null where it does not. */
    fun directionOf(light: LightModel): LightModel? {
        val place = light.placement?.view ?: return null
        val isItsOwn = light.attenuation?.let { it.error <= AttenuationFit.ACCEPTED && it.from == null } != false
        if (isItsOwn) return null
        return lights.firstOrNull { it !== light && isAt(it, place) && (it.attenuation?.error ?: 1.0) <= AttenuationFit.ACCEPTED }
    }

    private fun isAt(
        light: LightModel,
        place: Vector3dc,
    ) = light.placement?.view?.let { it.distance(place) < SAME } == true

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
            val suns = { seen: BlackBox, colors: ColorSlots -> Suns.among(seen, colors, formula, capture, number) }
            val clear = Fog.over(box)?.let(box::without) ?: box
            val (sight, normalsMoved) = Sight.of(clear, surface, suns)
            val (look, colors) = sight.look to sight.colors
            val decoded = look.box
            if (colors.lights.isEmpty() && colors.bent(box, LightSearch(box, surface).samples(LightSearch.FEW_DIRECTIONS)).isNotEmpty()) {
                throw InputError("the lights cannot be told apart: what each adds depends on the others")
            }
            val search = look.search
            val samples = LightSearch(decoded, surface).samples(LightSearch.FEW_DIRECTIONS)
            val roles = sight.lit.roles
            val lights = if (roles == null) emptyList() else sight.lit.probes.mapNotNull { LightStudy(search, roles).of(it) }
            val emission = EmissionStudy.of(decoded, colors, roles)
            return ProgramStudy(
                number, decoded, formula, colors, roles, decoded.exponent, lights, emission,
                SilentLights.of(decoded, colors, surface, roles),
                normalsMoved,
                colors.lights.isNotEmpty() && isAwake(box, decoded),
                ConelessLights.of(decoded, colors, surface, roles, lights),
                HiddenLights.areThere(decoded, colors, samples), SamplerFacts.of(capture, number),
                sentValues(capture, number, draw), look.deadly, look.afterGamma == null,
                AttributeOverlap.isThere(capture, number), roles?.let { LentColor.among(lights, it, samples) }.orEmpty(), surface,
                Representative.other(capture, number, formula, decoded),
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
            val values = program.values(draw)
            val formula =
                GeometryFormula.of(rig, program, active, values)
                    ?: throw InputError("no vertex attribute moves the vertices")
            val matrices = program.uniforms.filter { it.type == GL_FLOAT_MAT4 && it.name in values }.map { it.name }
            val spaces =
                Spaces.of(formula, matrices, values) ?: throw InputError("what is done with its matrices is not understood")
            val sizes = draw.attributes.associate { it.location to it.size }
            val others = active - formula.positionLocation
            val normal = others.filter { sizes[it] == 3 }.let { threes ->
                threes.singleOrNull()
                    ?: threes.firstOrNull { isNormal(DrawVertices(capture, draw), it) }
            }
            return BlackBox(rig, program, formula.positionLocation, normal, others.filter { it != normal }, spaces, values) to formula
        }

        /** Values of each uniform over all draws of program [number], those of [draw] last. */
        private fun sentValues(
            capture: Capture,
            number: Int,
            draw: CapturedDraw,
        ): Map<String, List<FloatArray>> = (capture.drawsOf(number) + draw).flatMap { it.uniforms }.groupBy({ it.name }, { it.numbers })

        private fun isNormal(
            vertices: DrawVertices,
            location: Int,
        ): Boolean =
            vertices.distinct.take(20).all { v ->
                val n = vertices.read(location, v) ?: return false
                Vector3d(n[0], n[1], n[2]).length() in 0.98..1.02
            }

        /** Points on the surface of the draw and a little off it, in view space. */
        fun surface(
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

        private fun isAwake(
            box: BlackBox,
            studied: BlackBox,
        ) = SilentLights.zeros(box).any { studied.values[it.name]?.contentEquals(box.values[it.name]) == false }

        /** View-space units. */
        private const val SAME = 1e-2
        private const val SURFACE = 240
    }
}
