package cga.grading.sheet4.scene

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Measured
import cga.grading.findings.Message
import cga.grading.findings.Mistake

/** What is lacking: the colours of the emission, the motorcycle's own, or anything else. */
internal enum class LackKind { COLOR, OWN_COLOR, OTHER }

/**
 * Something that is not there because its numbers may never have arrived.
 *
 * @param checks that cannot be right without it.
 * @param hides mistakes that it looks like.
 */
internal class Lack(val text: Message, val checks: Set<Check>, val kind: LackKind, val hides: Set<Mistake>)

/**
 * What one axis of the fitted model says.
 *
 * @param measured of its check, null where it says nothing of one.
 * @param mistake that it is wrong by; null where it is right, or wrong in a way without a name.
 * @param lack whether that may be explained by numbers that never arrive.
 * @param note what else a grader should know.
 */
internal class Axis private constructor(
    val measured: Measured?,
    val mistake: Found? = null,
    val lack: Lack? = null,
    val note: Message? = null,
) {
    /** The same, which numbers that never arrive would explain: [text] is lacking, and [more] checks cannot be right without. */
    fun lacking(text: Message, vararg more: Check, kind: LackKind = LackKind.OTHER, hides: Set<Mistake> = emptySet()): Axis =
        Axis(measured, mistake, Lack(text, setOfNotNull(measured?.check) + more, kind, hides), note)

    /** The same without a name, as something that was measured: what explains it is charged. */
    fun unnamed(): Axis = Axis(measured?.let { if (it.found) it else Measured.of(it.check, 1.0, it.message) }, null, null, note)

    companion object {
        fun right(check: Check, error: Double, text: Message): Axis = Axis(Measured.of(check, bounded(error), text))

        /** What could not be seen: for a person. */
        fun open(check: Check, text: Message): Axis = Axis(Measured.open(check, text))

        /** What is not there earns nothing. */
        fun absent(check: Check, text: Message, mistake: Found? = null): Axis = Axis(Measured.absent(check, text), mistake)

        fun wrong(
            check: Check,
            error: Double,
            text: Message,
            mistake: Mistake,
            where: String,
            fit: Double = 0.0,
            alternatives: List<Mistake> = emptyList(),
            explains: Set<Check>? = null,
        ): Axis = Axis(Measured.of(check, bounded(error), text), found(mistake, where, error, fit, alternatives, explains))

        fun note(text: Message): Axis = Axis(null, note = text)

        fun named(mistake: Found, note: Message?): Axis = Axis(null, mistake, note = note)

        fun found(
            mistake: Mistake,
            where: String,
            error: Double = 1.0,
            fit: Double = 0.0,
            alternatives: List<Mistake> = emptyList(),
            explains: Set<Check>? = null,
        ): Found = Found(mistake, bounded(if (mistake == Mistake.UNKNOWN) 1.0 else fit), bounded(error), where, alternatives, explains)

        private fun bounded(error: Double) = if (error.isNaN()) 1.0 else error.coerceIn(0.0, 1.0)
    }
}

/** The worst that is said of each check. */
internal fun List<Axis>.checks(): List<Measured> =
    mapNotNull { it.measured }.groupBy { it.check }.values.map { same -> same.maxBy { if (it.found) it.error ?: -1.0 else 2.0 } }

/** The mistakes, the same on several lights once: what explains much comes first. */
internal fun List<Axis>.mistakes(): List<Found> =
    mapNotNull { it.mistake }
        .groupBy { it.mistake }
        .values
        .map { same ->
            Found(
                same[0].mistake,
                same.maxOf { it.fit },
                same.maxOf { it.difference },
                same.map { it.where }.distinct().joinToString(),
                same.flatMap { it.alternatives }.distinct(),
                same.mapNotNull { it.explains }.takeIf { it.isNotEmpty() }?.flatten()?.toSet(),
            )
        }.sortedBy { found -> TELLING.indexOf(found.mistake).let { if (it < 0) TELLING.size + found.mistake.ordinal else it } }

private val TELLING =
    listOf(
        Mistake.SHADER_REFUSED, Mistake.GLSL_DRIVER, Mistake.UNIFORM_BEFORE_USE, Mistake.UNIFORM_ABSENT, Mistake.LIGHTS_AFTER_DRAWS,
        Mistake.LIGHT_MISSING, Mistake.SPOT_MISSING, Mistake.LIGHT_POSITION_OVERWRITTEN,
    )
