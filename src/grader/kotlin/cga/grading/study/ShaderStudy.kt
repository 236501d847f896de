package cga.grading.study

import cga.framework.InputError
import cga.grading.capture.Capture
import cga.grading.capture.CapturedFrame
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.findings.Plot
import cga.grading.scene.ObservedFrame
import kotlin.math.roundToInt

/**
 * What the shaders of a submission compute, found out by running them: no name in them is relied on.
 *
 * Each program is studied once, by the draw whose model matrix tells spaces apart best. Needs a current context for [of] and until [close];
 * changes the context's state freely.
 *
 * @property mistakes what is wrong with the shading, each mistake once.
 * @property checks how far the shading is from right, for the checks that shaders decide; null errors where nothing could be measured.
 * @property plots measured curves over expected ones.
 * @property notes what could not be studied, and why.
 */
public class ShaderStudy private constructor(
    private val rig: ProbeRig,
    private val programs: List<ProbeProgram>,
    private val observations: Observations,
    internal val materials: Materials,
    public val mistakes: List<Found>,
    public val checks: List<Measured>,
    public val plots: List<Plot>,
    public val notes: List<String>,
    private val studied: Collection<ProgramStudy>,
) : AutoCloseable {
    /** Whether the shaders could limit a light to a cone, while none has one. */
    internal val canCone: Boolean get() = studied.any { it.coneless.canCone }

    /** Uniforms that nobody sends and that leave no number of the picture, where that is no mistake with a name. */
    internal val deadly: Set<String>
        get() = if (mistakes.any { it.mistake == Mistake.CONE_NEVER_SENT }) emptySet() else studied.flatMap { it.deadly }.toSet()

    /** Names of lights in whose colour another one shines too, where none has a cone. */
    internal val lent: Set<String> get() = studied.flatMap { it.lent }.toSet()

    /** Names of lights that shine unevenly, and in no cone around a direction. */
    internal val strange: Set<String>
        get() = studied.flatMap { it.shining }.filter(LightDeviations::isStrange).map { it.name }.toSet()

    /** What [frame] of the capture shows in terms of the scene; null where no draw of it is understood. */
    public fun observe(frame: CapturedFrame): ObservedFrame? = observations.of(frame)

    override fun close() {
        programs.forEach { it.close() }
        rig.close()
    }

    public companion object {
        /** Studies every program that [capture] draws with, but for those that are [unlit]. What cannot be studied becomes a note. */
        public fun of(
            capture: Capture,
            unlit: Set<Int> = emptySet(),
        ): ShaderStudy {
            val rig = ProbeRig()
            val notes = mutableListOf<String>()
            val programs = mutableListOf<ProbeProgram>()
            val studies = LinkedHashMap<Int, ProgramStudy>()
            val draws = capture.draws.groupBy { it.program }.minus(unlit)
            for ((number, all) in draws) {
                try {
                    val captured = capture.programs.getOrNull(number) ?: throw InputError("program $number was not captured")

                    fun study(isDeep: Boolean): ProgramStudy {
                        val program = ProbeProgram(captured, isDeep, SamplerFacts.depthMaps(capture, number)).also(programs::add)
                        return ProgramStudy.of(rig, program, capture, number, Representative.of(rig, program, capture, number, all))
                    }
                    val plain = study(isDeep = false)
                    val deep = if (plain.hidesLights) study(isDeep = true) else plain
                    studies[number] = if (deep.lights.size > plain.lights.size) deep else plain
                } catch (e: InputError) {
                    notes += "program $number: ${e.message}"
                }
            }
            // What stands in for shaders that do not compile is not the submission's.
            val all = studies.filterKeys { !capture.programs[it].substituted }.values
            // Beside shaders with lights, those that know neither light nor texture draw something else: sparks, a trail.
            val own = all.filter { it.isOfScene || all.none(ProgramStudy::isOfScene) }
            own.filter(ProgramDeviations::isRepeated).forEach {
                notes += "The emission is added ${it.emission.strength.roundToInt()} times, as if once for each light; wanted: once."
            }
            val mistakes = own.flatMap { ProgramDeviations.of(it) }.distinctBy { it.mistake }
            val unknown = own.flatMap { ProgramDeviations.unnamed(it) }
            val checks = StudyChecks.of(own, mistakes, unknown)
            return ShaderStudy(
                rig, programs,
                Observations(
                    capture,
                    studies,
                ),
                Materials(rig, capture, studies), mistakes, checks, StudyPlots.of(own), notes, own,
            )
        }
    }
}
