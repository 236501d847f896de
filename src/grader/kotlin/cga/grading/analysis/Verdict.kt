package cga.grading.analysis

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.rubric.disturbedBy
import cga.grading.sheet4.scene.SceneVerdict

/**
 * One verdict from two witnesses: the study, which knows what the shaders compute, and the scene, which knows what happens over time.
 *
 * 1. What the study says of lights that never shine is said of nothing.
 * 2. Where both judge one thing, the one that sees its cause is believed ([Quarrel]).
 * 3. Mistakes that are only traces of another are dropped ([VerdictTraces]); what they cost is explained by it.
 * 4. A check has the larger of both errors. What the submission does not have is not found, except where its shaders could do it.
 *
 * @property checks one for each [Check], in order.
 * @property mistakes most telling first, each once; [Found.explains] is determined for all.
 */
internal class Verdict private constructor(
    val checks: List<Measured>,
    val mistakes: List<Found>,
) {
    companion object {
        fun of(
            shading: ShadingVerdict,
            scene: SceneVerdict,
        ): Verdict {
            val quarrel = Quarrel(shading, scene)
            val all = merged(quarrel.scene + quarrel.shading)
            val causes = all.filterNot { found -> all.any { it !== found && VerdictTraces.isTrace(found, it) } }
            val known = causes.filterNot {
                it.mistake == Mistake.UNKNOWN && causes.any { other ->
                    other.where == it.where && other !== it
                }
            }
            val checks = VerdictChecks(shading, scene, known).all()
            val dim = if (needed(known) <= scene.unlit.size) known.map { it.mistake }.filter(VerdictTraces::saysMissing) else emptyList()
            // Numbers that never arrive hide nothing where no shader would do anything with them.
            val isShading = shading.checks.any { it.check in VerdictTraces.SHADING && it.error != null }
            val dark = if (isShading) emptySet() else checks.filter { !it.found }.map { it.check }.toSet()
            val mistakes =
                known
                    .map { explained(it, all, it.mistake in dim, quarrel.unfounded.isNotEmpty(), checks) }
                    .map { copy(it, it.explains.orEmpty() - dark) }
            val unknown = if (all.any { it.mistake == Mistake.UNKNOWN }) null else unexplained(checks, mistakes)
            return Verdict(checks, mistakes + listOfNotNull(unknown))
        }

        /** What is wrong and no mistake explains: to be said, honestly, as unknown. */
        private fun unexplained(
            checks: List<Measured>,
            mistakes: List<Found>,
        ): Found? {
            val named = mistakes.flatMap { (listOf(it.mistake) + it.alternatives).map(Mistake::check) + it.explains.orEmpty() }
            val open = checks.filter { it.found && (it.error ?: 0.0) > OFF && it.check !in named }
            val worst = open.maxByOrNull { it.error ?: 0.0 } ?: return null
            return Found(Mistake.UNKNOWN, 1.0, worst.error ?: 1.0, open.joinToString { it.check.id }, explains = emptySet())
        }

        /** No tolerance of the rubric is as wide, but that for a further light of two. */
        private const val OFF = 0.3

        /** The same mistake of both witnesses is one. */
        private fun merged(found: List<Found>): List<Found> =
            found.groupBy { it.mistake }.values.map { same ->
                val first = same.first()
                val explains = same.mapNotNull { it.explains }.takeIf { it.isNotEmpty() }?.flatten()?.toSet()
                val where = same.map { it.where }.filter { it.isNotEmpty() }.distinct().joinToString()
                Found(
                    first.mistake,
                    same.minOf {
                        it.fit
                    },
                    same.maxOf { it.difference }, where, same.flatMap { it.alternatives }.distinct(), explains,
                )
            }

        /** How many lights are missing at least. */
        private fun needed(known: List<Found>): Int = known.sumOf { VerdictTraces.lights(it.mistake) }

        /**
         * [cause] with all that it explains: what it disturbs by its nature if that is there at all, and what its traces would have cost.
         *
         * @param isDim whether it says that a light is missing that the shaders could show: then it costs no more than itself.
         * @param isVoid whether something was measured where no light arrives.
         */
        private fun explained(
            cause: Found,
            all: List<Found>,
            isDim: Boolean,
            isVoid: Boolean,
            checks: List<Measured>,
        ): Found {
            if (cause.mistake == Mistake.UNKNOWN) return cause
            // All that could be seen was seen: that is no reason for points.
            if (cause.mistake == Mistake.GLSL_DRIVER || cause.mistake == Mistake.SHADER_REFUSED) return copy(cause, emptySet())
            val absent = checks.filter { !it.found }.map { it.check }.toSet()
            val traces = all.filter { it !== cause && VerdictTraces.isTrace(it, cause) }.flatMap { VerdictTraces.checks(it.mistake) }
            val isMissing = VerdictTraces.saysMissing(cause.mistake) || VerdictTraces.isLoss(cause)
            val void = if (isVoid && isMissing) VerdictTraces.SHADING else emptySet()
            val own = if (isDim) VerdictTraces.checks(cause.mistake) else emptySet()
            return copy(cause, cause.explains.orEmpty() + (disturbedBy(cause.mistake) + void - absent) + traces + own)
        }

        private fun copy(
            found: Found,
            explains: Set<Check>,
        ) = Found(found.mistake, found.fit, found.difference, found.where, found.alternatives, explains)
    }
}
