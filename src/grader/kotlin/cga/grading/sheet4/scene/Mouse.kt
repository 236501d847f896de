package cga.grading.sheet4.scene

import cga.grading.capture.Cursor
import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.findings.Mistake
import java.lang.Math.IEEEremainder
import kotlin.math.PI
import kotlin.math.abs

/** What the mouse did before a moment: its place in pixels from the top left; a rest where [isEvent] is not true. */
internal class MouseMove(val moment: Moment, val at: Cursor, val isEvent: Boolean) {
    val alt: Boolean get() = Key.LEFT_ALT in moment.keys

    companion object {
        /** From [Moment.MOUSE_FIRST] on as long as nothing is driven. */
        val ALL: List<MouseMove> =
            Moment.entries
                .filter { it >= Moment.MOUSE_FIRST && Key.FORWARD !in it.keys }
                .runningFold(null as MouseMove?) { last, moment ->
                    MouseMove(moment, moment.mouse ?: last?.at ?: Cursor(0.0, 0.0), moment.mouse != null)
                }.filterNotNull()
    }
}

/** Which events of the mouse a submission hears. */
internal enum class Heard(val hears: (MouseMove) -> Boolean) {
    ALL({ true }),
    ALT({ it.alt }),
    NO_ALT({ !it.alt }),
}

/** What is made of an event: pixels, from where the mouse is, was before and was first, and from what was made of the event before. */
internal enum class Way(
    val mistake: Mistake?,
    val key: String,
    val where: String,
    val pixels: (at: Cursor, old: Cursor, first: Cursor, before: Double) -> Double,
) {
    DIFFERENCE(null, "", "", { at, old, _, _ -> at.x - old.x }),
    SINCE_FIRST(Mistake.MOUSE_FACTOR, "mouse.since-first", "the whole way since the first event", { at, _, first, _ -> at.x - first.x }),

    /** The angle is that of the last movement and not of all. */
    ASSIGNED(Mistake.MOUSE_FACTOR, "mouse.assigned", "the last movement in the place of all", { at, old, _, before ->
        at.x - old.x - before
    }),
    OLD_Y(Mistake.MOUSE_FACTOR, "mouse.old-y", "the difference between x and the y before", { at, old, _, _ -> at.x - old.y }),
    POSITION(Mistake.MOUSE_JUMP, "mouse.position", "the position in the place of the movement", { at, _, _, _ -> at.x }),
    HEIGHT(Mistake.UNKNOWN, "mouse.height", "", { at, old, _, _ -> at.y - old.y }),
}

/** Where the mouse is taken to have been before the first event that is heard. */
internal enum class Start {
    /** Nowhere: the first event turns nothing. */
    NONE,

    /** In the corner of the screen. */
    CORNER,

    /** In the corner, as the first event turns nothing and its place is forgotten. */
    FORGOTTEN,
}

/**
 * A hypothesis about what the camera is turned by: so many pixels at each move.
 *
 * @param isFollowed whether the mouse's place is followed also where its events are not heard.
 * @param lag how many pictures later it is seen.
 */
internal data class MouseRule(val way: Way, val heard: Heard, val start: Start, val isFollowed: Boolean, val lag: Int) {
    /** The check that it costs, where it is wrong. */
    val mistake: Mistake? get() = way.mistake ?: if (start == Start.NONE) null else Mistake.MOUSE_JUMP

    /** Of each of [MouseMove.ALL]. */
    val pixels: List<Double> by lazy {
        val all = simulated()
        List(lag) { 0.0 } + all.dropLast(lag)
    }

    /** What is still to be seen after the last of them. */
    val pending: Double by lazy { simulated().takeLast(lag).sum() }

    private fun simulated(): List<Double> {
        var old: Cursor? = if (start == Start.CORNER) CORNER else null
        var first: Cursor? = null
        var before = 0.0
        return MouseMove.ALL.map { move ->
            val isHeard = move.isEvent && heard.hears(move)
            val from = old
            val made = if (!isHeard || from == null) 0.0 else way.pixels(move.at, from, first ?: from, before)
            if (isHeard && from != null) before = if (way == Way.ASSIGNED) made + before else made
            if (isHeard) first = first ?: move.at
            if (isHeard || (isFollowed && move.isEvent)) old = if (start == Start.FORGOTTEN && old == null) CORNER else move.at
            made
        }
    }

    companion object {
        private val CORNER = Cursor(0.0, 0.0)

        /** The simplest first; those that are right before those that are not. */
        val ALL: List<MouseRule> = buildList {
            for (lag in 0..1) {
                for (way in Way.entries) {
                    for (start in Start.entries.filter { it == Start.NONE || way == Way.DIFFERENCE }) {
                        for (heard in Heard.entries) {
                            for (isFollowed in listOf(true, false)) add(MouseRule(way, heard, start, isFollowed, lag))
                        }
                    }
                }
            }
        }.sortedBy { it.mistake != null }
    }
}

/**
 * A rule with the pace that fits it best.
 *
 * @param pace radians a pixel; its sign says which way.
 * @param residual the largest angle left, relative to the largest that was turned.
 */
internal class Paced(val rule: MouseRule, val pace: Double, val residual: Double) {
    companion object {
        /** Relative: float matrices turn by 1e-6 of themselves. */
        private const val HOLDS = 5e-3
        private const val SAME_PACE = 0.02

        /** A pace may be any: that explains less than a rule. */
        private const val OTHER_PACE = 1.1

        /**
         * The rule that explains [angles], radians in (−π, π] for each of [MouseMove.ALL], with [later] after the last of them; null where none
         * does. Of several the one with the fewest things changed, one of which is a pace that is not [expected]. The first move is judged by
         * itself: it may turn anything.
         */
        fun of(angles: List<Double>, later: Double?, expected: Double?): Paced? =
            MouseRule.ALL.mapNotNull { rule -> fit(rule, angles, later)?.takeIf { it.residual <= HOLDS } }.minByOrNull { paced ->
                val isPace = expected == null || abs(abs(paced.pace) / expected - 1) <= SAME_PACE
                (if (paced.rule.mistake == null) 0.0 else 1.0) + (if (isPace) 0.0 else OTHER_PACE)
            }

        private fun fit(rule: MouseRule, angles: List<Double>, later: Double?): Paced? {
            val seen = angles.indices.drop(1).map { rule.pixels[it] to angles[it] } +
                if (rule.lag > 0 && later != null) listOf(rule.pending to later) else emptyList()
            val least = seen.filter { it.first != 0.0 }.minByOrNull { abs(it.first) } ?: return null
            // Far turns come round again: the least one tells how often.
            val rough = least.second / least.first
            val whole = seen.map { (pixels, angle) -> pixels to angle + 2 * PI * Math.rint((rough * pixels - angle) / (2 * PI)) }
            val pace = whole.sumOf { it.first * it.second } / whole.sumOf { it.first * it.first }
            val left = seen.maxOf { (pixels, angle) -> abs(IEEEremainder(angle - pace * pixels, 2 * PI)) }
            return Paced(rule, pace, left / whole.maxOf { abs(it.second) })
        }
    }
}
