package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Mistake

/**
 * What the scene does over the frames, judged.
 *
 * @param checks at most one entry for a check; [SceneJudge.CHECKS] says which.
 * @param mistakes most telling first.
 * @param notes what else a grader should know.
 * @param unlit names of the lights that give no light in any frame: whatever is said of their shading is said of nothing. Among them are all
 * uniforms that are 0 for ever, and those that the sources declare and no program has: the compiler drops what nothing is made of.
 * @param spot name of the light that was taken for the headlight, null where none was.
 * @param isReplaced whether shaders that the driver refused were replaced by stand-ins, so that no shading can be seen.
 */
public class SceneVerdict(
    public val checks: List<Measured>,
    public val mistakes: List<Found>,
    public val notes: List<String>,
    public val unlit: Set<String> = emptySet(),
    public val isReplaced: Boolean = false,
    public val spot: String? = null,
) {
    /** The entry for [check], or null. */
    public operator fun get(check: Check): Measured? = checks.find { it.check == check }

    /** The entry for [mistake], or null. */
    public operator fun get(mistake: Mistake): Found? = mistakes.find { it.mistake == mistake }
}

/** A verdict being written. */
internal class Notebook {
    private val checks = LinkedHashMap<Check, Measured>()
    private val mistakes = ArrayList<Found>()
    private val notes = LinkedHashSet<String>()

    private val lacks = ArrayList<Lack>()

    /** Names of the lights that never give light. */
    var unlit: Set<String> = emptySet()

    /** Name of the headlight. */
    var spot: String? = null

    /** Whether stand-ins took the place of shaders. */
    var isReplaced: Boolean = false

    /** What of the scene is not there at all and might be explained by an event. */
    val missing: List<String> get() = lacks.map { it.text }

    private class Lack(
        val text: String,
        val checks: Set<Check>,
        val mistakes: Set<Mistake>,
    )

    /** Puts the measurement of [check] down; a second one of the same check replaces the first. */
    fun measured(
        check: Check,
        error: Double?,
        text: String,
    ) {
        checks[check] = Measured(check, error?.let(::bounded), text)
    }

    /** Puts [check] down as something that the submission does not have. */
    fun absent(
        check: Check,
        text: String,
    ) {
        checks[check] = Measured(check, 1.0, text, found = false)
    }

    /**
     * Notes that something is not there.
     *
     * @param text what, as in "the point light".
     * @param checks that cannot be right without it.
     * @param mistakes that say no more than that it is not there.
     */
    fun lacks(
        text: String,
        checks: Set<Check>,
        mistakes: Set<Mistake>,
    ) {
        if (text !in missing) lacks += Lack(text, checks, mistakes)
    }

    /** Names [cause] as the reason for all that is lacking: that has no names of its own any more and costs nothing. */
    fun explained(
        cause: Mistake,
        where: String,
        alternatives: List<Mistake> = emptyList(),
    ) {
        lacks.flatMap { it.mistakes }.forEach(::remove)
        mistakes += Found(cause, 0.0, 1.0, where, alternatives, lacks.flatMap { it.checks }.toSet())
        if (lacks.isNotEmpty()) note("Missing because of that: ${missing.joinToString()}.")
    }

    /** Takes back everything about [all], and every mistake that does not belong to the checks [but]. */
    fun unmeasured(
        all: Collection<Check>,
        but: Set<Check>,
        text: String,
    ) {
        all.forEach { measured(it, null, text) }
        mistakes.removeIf { it.mistake.check !in but }
    }

    /** Puts [check] down as spoilt, where nothing worse is known of it. */
    fun spoilt(
        check: Check,
        error: Double,
        text: String,
    ) {
        val known = checks[check]?.error
        if (known == null || known < error) measured(check, error, text)
    }

    /** The error so far, or null. */
    fun error(check: Check): Double? = checks[check]?.error

    fun found(
        mistake: Mistake,
        fit: Double,
        difference: Double,
        where: String,
        alternatives: List<Mistake> = emptyList(),
        explains: Set<Check>? = null,
    ) {
        mistakes += Found(mistake, bounded(fit), bounded(difference), where, alternatives, explains)
    }

    fun has(mistake: Mistake): Boolean = mistakes.any { it.mistake == mistake }

    fun remove(mistake: Mistake) {
        mistakes.removeIf { it.mistake == mistake }
    }

    fun note(text: String) {
        notes += text
    }

    fun verdict(): SceneVerdict {
        val merged = mistakes.groupBy { it.mistake }.values.map(::merged)
        return SceneVerdict(checks.values.toList(), merged.sortedBy { rank(it.mistake) }, notes.toList(), unlit, isReplaced, spot)
    }

    /** The same mistake on several lights is one. */
    private fun merged(same: List<Found>): Found {
        val where = same.map { it.where }.distinct().joinToString()
        val alternatives = same.flatMap { it.alternatives }.distinct()
        val explains = same.mapNotNull { it.explains }.flatten().toSet().takeIf { same.any { it.explains != null } }
        return Found(same.first().mistake, same.maxOf { it.fit }, same.maxOf { it.difference }, where, alternatives, explains)
    }

    // What explains much comes first: a uniform that never arrives before a light that is missing because of it.
    private fun rank(mistake: Mistake) = TELLING.indexOf(mistake).let { if (it < 0) TELLING.size + mistake.ordinal else it }

    private fun bounded(error: Double) = if (error.isNaN()) 1.0 else error.coerceIn(0.0, 1.0)

    private companion object {
        val TELLING =
            listOf(
                Mistake.SHADER_REFUSED,
                Mistake.GLSL_DRIVER,
                Mistake.UNIFORM_BEFORE_USE,
                Mistake.UNIFORM_ABSENT,
                Mistake.LIGHTS_AFTER_DRAWS,
                Mistake.LIGHT_MISSING,
                Mistake.SPOT_MISSING,
                Mistake.LIGHT_POSITION_OVERWRITTEN,
            )
    }
}
