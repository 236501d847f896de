package cga.grading.scene

import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.max

/**
 * Task 4.4: the ground's colour stays, the motorcycle's changes with time, its light shines in the same.
 *
 * @param isSent whether something is sent that no shader takes: then a colour that nothing shows may have been sent.
 */
internal class ColorJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val isSent: Boolean,
    private val book: Notebook,
) {
    private class Tint(
        val moment: Moment,
        val time: Double,
        val color: Vector3dc,
    )

    fun judge() {
        val all = listOf(timeline.cast.ground, timeline.cast.motorcycle).map(::tints)
        // White everywhere and always, written into the shader while a colour is sent to nobody, is none.
        val (ground, motorcycle) = if (isSent &&
            all.flatten().all { it.color.distance(WHITE) < DARK }
        ) {
            listOf(emptyList(), emptyList())
        } else {
            all
        }
        if ((ground + motorcycle).let { both -> both.isNotEmpty() && both.all { it.color.maxAbs() < DARK } }) {
            nothing()
        } else {
            ground(ground, isStill = motorcycle.isNotEmpty() && spread(motorcycle) <= CHANGE)
            motorcycle(motorcycle, ground)
        }
        light(motorcycle)
        if (ground.isEmpty() && motorcycle.isEmpty() && timeline.laterShots.isNotEmpty()) {
            val explains = if (isSent) setOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR) else emptySet()
            book.found(Mistake.EMISSION_COLOR_IGNORED, 0.0, 1.0, "ground and motorcycle", listOf(Mistake.COLOR_CONSTANT), explains)
        }
    }

    /** The emission is multiplied with black, always: no colour arrives. */
    private fun nothing() {
        val checks = setOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR)
        checks.forEach { book.measured(it, 1.0, "The emission is multiplied with black in every frame, so nothing glows.") }
        book.found(Mistake.EMISSION_MISSING, 0.0, 1.0, "ground and motorcycle", explains = checks)
        book.lacks(COLOR, checks, setOf(Mistake.EMISSION_MISSING))
    }

    private fun tints(track: Track?): List<Tint> =
        timeline.frames.filter { it.moment != Moment.FIRST }.mapNotNull { frame ->
            track?.of(frame)?.tint?.takeIf { it.isFinite }?.let { Tint(frame.moment, frame.time, it) }
        }

    /** @param isStill whether the motorcycle's colour never changes. */
    private fun ground(tints: List<Tint>, isStill: Boolean) {
        if (timeline.cast.ground == null) return book.measured(Check.GROUND_COLOR, null, "There is no ground to be seen.")
        if (tints.isEmpty()) return book.absent(Check.GROUND_COLOR, "No colour is multiplied with the ground's emission.")
        val color = tints.last().color
        val change = spread(tints) / max(tints.maxOf { it.color.maxAbs() }, DARK)
        when {
            // Each thing is drawn in the colour of the one before.
            change > CHANGE && isStill -> book.measured(
                Check.GROUND_COLOR,
                0.0,
                "The ground has the colour that changes, and the motorcycle has not: that costs at the motorcycle.",
            )
            change > STILL -> book.measured(
                Check.GROUND_COLOR,
                change,
                "The ground's colour changes; wanted: always the same. It was ${list(tints)}.",
            )
            color.distance(
                WHITE,
            ) < PLAIN -> book.measured(
                Check.GROUND_COLOR,
                1.0,
                "The ground's colour is white, which changes nothing; wanted: green or another.",
            )
            color.maxAbs() < PLAIN -> book.measured(Check.GROUND_COLOR, 1.0, "The ground's colour is black.")
            else -> book.measured(Check.GROUND_COLOR, 0.0, "The ground's colour is ${color.text()}, always.")
        }
    }

    private fun motorcycle(tints: List<Tint>, ground: List<Tint>) {
        if (tints.isEmpty()) return book.absent(Check.MOTORCYCLE_COLOR, "No colour is multiplied with the motorcycle's emission.")
        val standing = tints.filter { it.moment in STANDING }
        if (standing.size < 2) return book.measured(Check.MOTORCYCLE_COLOR, null, "There are too few frames.")
        val byStep = spread(tints) > CHANGE && isOfStep(tints)
        // A colour that update() only sets once the motorcycle drives.
        val isStill = spread(standing) < SAME
        if (spread(tints) > CHANGE && !byStep && !isStill) {
            return book.measured(Check.MOTORCYCLE_COLOR, 0.0, "The motorcycle's colour changes with time: ${list(standing)}.")
        }
        val text = when {
            byStep -> "The motorcycle's colour only depends on the time since the last picture; wanted: one that changes with time."
            spread(tints) > CHANGE -> "The motorcycle's colour only changes while it is driven; wanted: one that changes with time."
            else -> "The motorcycle's colour is always ${tints.last().color.text()}; wanted: one that changes with time."
        }
        book.measured(Check.MOTORCYCLE_COLOR, 1.0, text)
        if (isWritten()) {
            // No colour that the program gives can come through.
            book.found(Mistake.EMISSION_COLOR_IGNORED, 0.0, 1.0, "motorcycle", explains = setOf(Check.MOTORCYCLE_COLOR))
        } else {
            book.found(Mistake.COLOR_CONSTANT, 0.0, 1.0, "motorcycle")
            val isBlack = tints.all { it.color.maxAbs() < DARK }
            val isWorn = ground.isNotEmpty() && (tints + ground).all { it.color.distance(tints[0].color) < DARK }
            if (isBlack || isWorn) {
                book.lacks(if (isBlack) COLOR else OWN_COLOR, setOf(Check.MOTORCYCLE_COLOR), setOf(Mistake.COLOR_CONSTANT))
            }
        }
    }

    /** Whether the shader that draws the motorcycle has its colour as a constant. */
    private fun isWritten() = timeline.laterShots.mapNotNull { timeline.cast.motorcycle?.of(it.frame) }.let { all ->
        all.isNotEmpty() && all.all { it.isTintWritten }
    }

    /** Whether pictures that are equally long after the one before have one colour, whatever the time: made of dt instead of t. */
    private fun isOfStep(tints: List<Tint>): Boolean {
        val alike = tints.groupBy { it.moment.seconds }.values.filter { it.size > 1 }
        return alike.size > 1 && alike.all { spread(it) < SAME }
    }

    private fun light(tints: List<Tint>) {
        val own = roles.own ?: return book.absent(Check.LIGHT_COLOR, "There is no point light at the motorcycle.")
        val changes = spread(tints) > CHANGE
        val isPlain = tints.isEmpty() || tints.last().color.let { it.distance(WHITE) < PLAIN || it.maxAbs() < DARK }
        if (!changes && (own.changesColor || isPlain)) {
            // Sines on the light alone: what is missing is the motorcycle's colour, and costs there.
            val (error, what) = if (own.changesColor) 0.0 to "changes" else 1.0 to "never changes"
            return book.measured(Check.LIGHT_COLOR, error, "The light ${own.name} $what its colour.")
        }
        val worn = roles.spot?.takeIf { it !== own && book.has(Mistake.LIGHT_POSITION_OVERWRITTEN) && timeline.isOneColor(own, it) }
        if (worn != null) {
            return book.measured(
                Check.LIGHT_COLOR,
                0.0,
                "The light ${own.name} has the colour of ${worn.name}, and its place as well: that costs at the place.",
            )
        }
        val pairs = tints.mapNotNull { tint -> own.at(tint.moment)?.let { tint to it.color } }
        if (pairs.isEmpty()) return book.measured(Check.LIGHT_COLOR, null, "${own.name} is in no frame.")
        val slack = speed(tints) * SLACK
        val error = difference(pairs, slack)
        val late = late(own)
        if (error > DIFFERS && late.size > 1 && difference(late, slack) <= DIFFERS) {
            return book.measured(
                Check.LIGHT_COLOR,
                0.0,
                "The light ${own.name} has the motorcycle's colour of the frame before: that costs at the order.",
            )
        }
        book.measured(
            Check.LIGHT_COLOR,
            error,
            "The light ${own.name} is ${own.last.color.text()}, the motorcycle ${tints.last().color.text()}; wanted: the same.",
        )
        if (error > DIFFERS) book.found(Mistake.LIGHT_COLOR_DIFFERS, 0.0, error, own.name)
    }

    /** The light's colours with the tints of the frames before theirs: of a light that is bound when everything has been drawn. */
    private fun late(own: LightTrack): List<Pair<Tint, Vector3dc>> =
        timeline.frames.zipWithNext().mapNotNull { (before, now) ->
            val tint = timeline.cast.motorcycle?.of(before)?.tint?.takeIf { it.isFinite } ?: return@mapNotNull null
            own.at(now.moment)?.let { Tint(before.moment, before.time, tint) to it.color }
        }

    /** As the other [difference]; a sine may be negative, and a colour below 0 is none, for the emission and the light alike. */
    private fun difference(
        pairs: List<Pair<Tint, Vector3dc>>,
        slack: Double,
    ): Double = minOf(difference(pairs, slack) { it }, difference(pairs, slack) { Vector3d(it).max(Vector3d()) })

    /** Of light colours from the tints times one intensity, relative; [slack] of each difference is forgiven. */
    private fun difference(
        pairs: List<Pair<Tint, Vector3dc>>,
        slack: Double,
        seen: (Vector3dc) -> Vector3dc,
    ): Double {
        val both = pairs.map { (tint, color) -> seen(tint.color) to seen(color) }
        val intensity = both.sumOf { (tint, color) -> tint.dot(color) } / both.sumOf { (tint, _) -> tint.lengthSquared() }
        if (!(intensity > 0)) return 1.0
        val largest = both.maxOf { (tint, _) -> tint.length() }
        return both.maxOf { (tint, color) -> max(0.0, color.div(intensity, Vector3d()).distance(tint) - slack) } / largest
    }

    /** The fastest change of colour between frames that follow each other closely, a second. */
    private fun speed(tints: List<Tint>): Double =
        tints.zipWithNext().filter { (a, b) -> b.time > a.time && b.time - a.time <= CLOSE }.maxOfOrNull { (a, b) ->
            a.color.distance(b.color) / (b.time - a.time)
        } ?: 0.0

    private fun spread(tints: List<Tint>): Double = tints.maxOfOrNull { it.color.distance(tints.first().color) } ?: 0.0

    private fun list(tints: List<Tint>) = tints.joinToString { it.color.text() }

    companion object {
        /** What is lacking where the colour of the emission never arrives. */
        const val COLOR = "the colour of the emission"

        /** What is lacking where the motorcycle is drawn in the colour that was sent for the ground. */
        const val OWN_COLOR = "the motorcycle's own colour"

        private val WHITE: Vector3dc = Vector3d(1.0)
        private val STANDING = setOf(Moment.SECOND, Moment.TIME_1, Moment.TIME_2, Moment.TIME_3, Moment.TIME_4)
        private const val DARK = 1e-6
        private const val PLAIN = 0.02
        private const val STILL = 0.01

        /** A sixtieth of a second changes the slowest of the sheet's sines by 5 thousandths. */
        private const val SAME = 1e-3
        private const val CHANGE = 0.03
        private const val DIFFERS = 0.03

        /** Seconds: one update may already be behind or ahead of the picture, and a picture of the next. */
        private const val SLACK = 2.0 / 60
        private const val CLOSE = 0.05
    }
}
