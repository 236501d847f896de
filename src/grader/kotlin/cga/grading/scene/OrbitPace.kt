package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import kotlin.math.abs
import kotlin.math.hypot

/**
 * How fast the camera turns, and whether it waits for the mouse to move.
 *
 * @param expected radians a pixel; null: any.
 * @param isTilted whether the camera's circle is tilted: then it turns unevenly.
 */
internal class OrbitPace(
    private val expected: Double?,
    private val book: Notebook,
    private val isTilted: Boolean,
) {
    /** What each of the mouse's moves turned the camera by, radians. */
    fun judge(reactions: List<Pair<MouseMove, Double>>) {
        val sideways = reactions.filter { (move, angle) -> isSideways(move) && angle > OrbitJudge.TURNED }
        val pace = factor(sideways)
        val drifting = reactions.filter { (move, angle) -> isRest(move) && angle > OrbitJudge.TURNED }
        if (drifting.isNotEmpty()) {
            val (move, angle) = drifting.first()
            val text = "The camera goes on turning while the mouse rests: by ${angle.text()} rad in ${move.moment}; wanted 0."
            book.measured(Check.ORBIT_FACTOR, 1.0, text)
            book.found(Mistake.MOUSE_FACTOR, 0.0, 1.0, "turns while the mouse rests")
        }
        start(reactions, pace)
    }

    /** Puts the factor down; radians a pixel. */
    private fun factor(sideways: List<Pair<MouseMove, Double>>): Double {
        val wanted = expected ?: sideways.minOf { (move, angle) -> angle / abs(move.x) }
        val paces = sideways.map { (move, angle) -> angle / abs(move.x) }
        val isUneven = paces.max() > (1 + UNEVEN) * paces.min() && paces.max() < UNLIKE * paces.min()
        if (expected != null && isUneven && (isTilted || book.has(Mistake.ORBIT_PIVOT))) {
            book.measured(Check.ORBIT_FACTOR, 0.0, unevenly())
            return wanted
        }
        // Where the camera does not hear of every move and one disagrees, the position before it was not followed: its own numbers tell.
        val pace = paces.minBy { abs(it / wanted - 1) }
        val isDeaf = sideways.size < MouseMove.ALL.count(::isSideways)
        val others =
            sideways.zip(paces).filter { (reaction, its) ->
                val mayBeUnfollowed = isDeaf || (reaction == sideways.first() && sideways.size > 1)
                abs(its / pace - 1) > AGREES && !(mayBeUnfollowed && isUnfollowed(reaction, wanted))
            }
        val worst = (others.map { it.second } + pace).maxBy { abs(it / wanted - 1) }
        val alone = sideways.singleOrNull()
        val honest = if (alone != null && isUnfollowed(alone, wanted)) wanted else worst
        val error = if (expected == null) 0.0 else abs(honest / expected - 1)
        val list = paces.joinToString { it.text() }
        book.measured(
            Check.ORBIT_FACTOR,
            error,
            "The camera turns by $list rad a pixel" + if (expected == null) "." else "; wanted ${expected.text()}.",
        )
        if (error > NAMED) book.found(Mistake.MOUSE_FACTOR, 0.0, error, "${honest.text()} rad a pixel")
        return honest
    }

    private fun unevenly() =
        if (isTilted) {
            "The camera turns unevenly, as its circle is tilted: that costs at the orbit."
        } else {
            "The camera turns unevenly, as it circles one place and looks at another: that costs at the pivot."
        }

    /** Whether the angle is right for a difference to a position older than the last: of those who look only while Alt is (not) held. */
    private fun isUnfollowed(
        reaction: Pair<MouseMove, Double>,
        pace: Double,
    ): Boolean = olderDifferences(reaction.first).any { abs(reaction.second / (pace * it) - 1) < AGREES }

    private fun olderDifferences(move: MouseMove): List<Double> {
        val at = MouseMove.ALL.filter { it.moment <= move.moment }.sumOf { it.x }
        val before = MouseMove.ALL.filter { it.moment < move.moment }.runningFold(0.0) { x, next -> x + next.x }.distinct()
        return before.map { abs(at - it) }.filter { it > 0 && it != abs(move.x) }
    }

    private fun start(
        reactions: List<Pair<MouseMove, Double>>,
        pace: Double,
    ) {
        val (first, turned) = reactions.first()
        val late = reactions.firstOrNull { (move, angle) -> isSideways(move) && angle > OrbitJudge.TURNED }
        val jump =
            when {
                turned > pace -> first.moment to turned
                // The first event that is heard may be a later one, under Alt; or the position of the first was not remembered.
                late != null && isUnfollowed(late, pace) -> {
                    late.first.moment to late.second - pace * abs(late.first.x)
                }
                else -> null
            }
        if (jump == null) return book.measured(Check.ORBIT_START, 0.0, "The first mouse event does not turn the camera.")
        val (moment, angle) = jump
        val error = (angle / (pace * first.x)).coerceAtMost(1.0)
        book.measured(Check.ORBIT_START, error, "The first mouse event turns the camera by ${angle.text()} rad; wanted 0.")
        book.found(Mistake.MOUSE_JUMP, reason(turned / pace, first), error, "${(angle / pace).text()} pixels' worth at $moment")
    }

    /** How far the jump, in pixels, is from a difference to the corner of the screen, relative; by x alone or both coordinates. */
    private fun reason(
        pixels: Double,
        first: MouseMove,
    ): Double = listOf(first.x, first.x + 1, hypot(first.x, first.y)).minOf { abs(pixels / it - 1) }

    private fun isSideways(move: MouseMove) = !move.first && move.x != 0.0 && move.y == 0.0

    private fun isRest(move: MouseMove) = !move.first && move.x == 0.0 && move.y == 0.0

    private companion object {
        /** Relative. */
        const val AGREES = 0.005

        /** What looking at something else makes of even turns, and a wrong factor does not; what adds up is off by more. */
        const val UNEVEN = 0.01
        const val UNLIKE = 1.5
        const val NAMED = 0.02
    }
}
