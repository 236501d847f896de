package cga.grading.study

import cga.framework.InputError
import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedFrame
import cga.grading.capture.UniformValue
import org.lwjgl.opengl.GL33C.*

/**
 * Draws for which a switch turns the lights of their program off: lamps drawn in their own colour by a shader that can do both.
 *
 * @property capture with those as draws of programs of their own.
 * @property programs the numbers of these programs.
 */
internal class UnlitDraws private constructor(
    val capture: Capture,
    val programs: Set<Int>,
) {
    companion object {
        /** Looks for them in [capture]: wherever draws of one picture differ in a switch, whether there is light with it. Needs a current context. */
        fun of(capture: Capture): UnlitDraws {
            val dark =
                ProbeRig().use { rig ->
                    capture.programs.indices.associateWith { dark(rig, capture, it) }.filterValues { it.isNotEmpty() }
                }
            if (dark.isEmpty()) return UnlitDraws(capture, emptySet())
            val numbers = dark.keys.withIndex().associate { (i, program) -> program to capture.programs.size + i }
            val frames = capture.frames.map { frame ->
                val steps = frame.steps.map { step ->
                    if (step is CapturedDraw && step in dark[step.program].orEmpty()) step.with(numbers.getValue(step.program)) else step
                }
                CapturedFrame(frame.moment, frame.time, steps, frame.picture)
            }
            val programs = capture.programs + dark.keys.map { capture.programs[it] }
            val separated = capture.with(programs, frames)
            return UnlitDraws(separated, numbers.values.toSet())
        }

        private fun dark(
            rig: ProbeRig,
            capture: Capture,
            number: Int,
        ): Set<CapturedDraw> {
            val pictures = capture.frames.map { it.drawsOf(number) }
            val switches = pictures.flatMap(::switches).toSet()
            if (switches.isEmpty()) return emptySet()
            val kinds = pictures.flatten().groupBy { draw -> draw.uniforms.filter { it.name in switches }.map { it.numbers.toList() } }
            if (kinds.size > MOST) return emptySet()
            return try {
                ProbeProgram(capture.programs[number], depthMaps = SamplerFacts.depthMaps(capture, number)).use { program ->
                    val (lit, unlit) = kinds.values.partition { isLit(rig, program, capture, number, it) }
                    if (lit.isEmpty()) emptySet() else unlit.flatten().toSet()
                }
            } catch (_: InputError) {
                // Who studies the program says why it cannot be.
                emptySet()
            }
        }

        /** Uniforms that are on for some [draws] of a picture and off for others, or have different whole numbers. */
        private fun switches(draws: List<CapturedDraw>): Set<String> =
            draws
                .flatMap { it.uniforms }
                .filter(::canSwitch)
                .groupBy { it.name }
                .filterValues { all -> all.any { !it.numbers.contentEquals(all[0].numbers) } }
                .keys

        private fun canSwitch(uniform: UniformValue) =
            uniform.type in WHOLE || (uniform.type == GL_FLOAT && uniform.numbers[0].let { it == 0f || it == 1f })

        private fun isLit(
            rig: ProbeRig,
            program: ProbeProgram,
            capture: Capture,
            number: Int,
            draws: List<CapturedDraw>,
        ): Boolean {
            val draw = draws.asReversed().maxBy { it.count }
            val (box, formula) = ProgramStudy.box(rig, program, capture, number, draw)
            val search = LightSearch(box, ProgramStudy.surface(box, formula, DrawVertices(capture, draw)))
            val colors = ColorSlots.of(box, search.samples(LightSearch.FEW_DIRECTIONS), search.samples(LightSearch.MANY_DIRECTIONS))
            return colors.lights.isNotEmpty()
        }

        private fun CapturedDraw.with(program: Int) =
            CapturedDraw(
                program, mode, count, attributes, indices, indexType, first, baseVertex, instances, uniforms, textures, state, callers,
            )

        /** More kinds than that are numbers, not switches. */
        private const val MOST = 6
        private val WHOLE = setOf(GL_INT, GL_BOOL, GL_UNSIGNED_INT)
    }
}
