package cga.grading.findings

/**
 * What was measured of one submission. The analysis writes it, the parent reads it and makes points of it; it holds no points itself.
 *
 * @param checks one entry for each [Check], reached or not.
 * @param mistakes the hypotheses that explain what differs, most telling first.
 * @param proof how well all of them together explain it; null where that was not measured.
 */
public class Findings(
    public val checks: List<Measured>,
    public val mistakes: List<Found>,
    public val plots: List<Plot>,
    public val pictures: List<Evidence>,
    public val notes: List<Message>,
    public val proof: Proof? = null,
) {
    /** These findings with other [mistakes]. */
    public fun with(mistakes: List<Found>): Findings = Findings(checks, mistakes, plots, pictures, notes, proof)
}

/** What is known of a check. */
public enum class Standing {
    /** How far it is from the truth. */
    MEASURED,

    /** The submission has nothing there that could be measured (no spotlight, no orbit): that earns nothing. */
    ABSENT,

    /** It could not be measured: a person has to look. */
    OPEN,
}

/**
 * How far one check is from the truth, with every mistake that belongs elsewhere repaired.
 *
 * @param error relative to what is expected: 0 is exact, 1 is all of it; null where it was not measured.
 * @param message the figures behind it: what was measured and what was expected.
 */
public class Measured private constructor(
    public val check: Check,
    public val standing: Standing,
    public val error: Double?,
    public val message: Message,
) {
    /** As the judges before [Standing] say it: nothing is there unless [found], and it is open without an [error]. */
    public constructor(check: Check, error: Double?, text: String, found: Boolean = true) :
        this(check, standing(error, found), error, Message.plain(text))

    public val found: Boolean get() = standing != Standing.ABSENT
    public val text: String get() = "$message"

    public companion object {
        private fun standing(
            error: Double?,
            found: Boolean,
        ) = if (!found) {
            Standing.ABSENT
        } else if (error == null) {
            Standing.OPEN
        } else {
            Standing.MEASURED
        }

        /** [check] is off by [error]; open where that is no finite number. */
        public fun of(
            check: Check,
            error: Double,
            message: Message,
        ): Measured = if (error.isFinite()) Measured(check, Standing.MEASURED, error, message) else open(check, message)

        /** There is nothing of [check]. */
        public fun absent(
            check: Check,
            message: Message,
        ): Measured = Measured(check, Standing.ABSENT, null, message)

        /** Nobody can tell of [check]. */
        public fun open(
            check: Check,
            message: Message,
        ): Measured = Measured(check, Standing.OPEN, null, message)
    }
}

/**
 * A mistake that was recognised.
 *
 * @param fit what is left of the difference when the mistake is assumed, relative to the picture; 0 explains all.
 * @param difference how far the submission is from the truth without it.
 * @param where which light, object or file; the submission's own name of it where there is one.
 * @param alternatives mistakes that draw the same picture and that nothing tells apart.
 * @param explains checks that fail only because of this mistake: they are not charged again, found or not. Null where that was not
 *   determined: then those count that the mistake disturbs by its nature.
 * @param details more to say of it, each a sentence.
 * @param places where it is written: the line of a shader, or the Kotlin that made the call and those that called it, the most telling first.
 * @param proof how well it explains what differs; null where that was not measured.
 */
public class Found(
    public val mistake: Mistake,
    public val fit: Double,
    public val difference: Double,
    public val where: String,
    public val alternatives: List<Mistake> = emptyList(),
    public val explains: Set<Check>? = null,
    public val details: List<Message> = emptyList(),
    public val places: List<Place> = emptyList(),
    public val proof: Proof? = null,
) {
    /** The same, written at [places]. */
    public fun at(places: List<Place>): Found =
        if (places == this.places) this else Found(mistake, fit, difference, where, alternatives, explains, details, places, proof)
}

/** A measured curve and the one expected, over the same [x]. */
public class Plot(
    public val check: Check,
    public val title: String,
    public val xLabel: String,
    public val yLabel: String,
    public val x: DoubleArray,
    public val measured: DoubleArray,
    public val expected: DoubleArray,
)

/**
 * Pictures that prove something: PNG files beside the findings.
 *
 * @param measured file name of what the submission draws; [expected] of what it should draw, null where there is nothing to compare.
 */
public class Evidence(
    public val check: Check?,
    public val title: Message,
    public val measured: String,
    public val expected: String?,
)
