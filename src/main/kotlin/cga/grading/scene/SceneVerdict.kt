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
 */
public class SceneVerdict(
    public val checks: List<Measured>,
    public val mistakes: List<Found>,
    public val notes: List<String>,
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

    /** What of the scene is not there at all and might be explained by an event: `the point light`. */
    val missing = LinkedHashSet<String>()

    /** Puts the measurement of [check] down; a second one of the same check replaces the first. */
    fun measured(
        check: Check,
        error: Double?,
        text: String,
    ) {
        checks[check] = Measured(check, error?.let(::bounded), text)
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
    ) {
        mistakes += Found(mistake, bounded(fit), bounded(difference), where, alternatives)
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
        return SceneVerdict(checks.values.toList(), merged.sortedBy { rank(it.mistake) }, notes.toList())
    }

    /** The same mistake on several lights is one. */
    private fun merged(same: List<Found>): Found {
        val where = same.map { it.where }.distinct().joinToString()
        val alternatives = same.flatMap { it.alternatives }.distinct()
        return Found(same.first().mistake, same.maxOf { it.fit }, same.maxOf { it.difference }, where, alternatives)
    }

    // What explains much comes first: a uniform that never arrives before a light that is missing because of it.
    private fun rank(mistake: Mistake) = TELLING.indexOf(mistake).let { if (it < 0) TELLING.size + mistake.ordinal else it }

    private fun bounded(error: Double) = if (error.isNaN()) 1.0 else error.coerceIn(0.0, 1.0)

    private companion object {
        val TELLING =
            listOf(
                Mistake.UNIFORM_BEFORE_USE,
                Mistake.UNIFORM_ABSENT,
                Mistake.LIGHTS_AFTER_DRAWS,
                Mistake.LIGHT_MISSING,
                Mistake.SPOT_MISSING,
                Mistake.LIGHT_POSITION_OVERWRITTEN,
            )
    }
}
