package cga.grading.scene

import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake

/** Task 4.5: the mouse takes the camera about the motorcycle, with or without Alt, as the submission likes it. */
internal class OrbitJudge(
    private val timeline: Timeline,
    private val profile: SceneProfile,
    private val book: Notebook,
) {
    fun judge() {
        val turns = turns(0)
        if (turns.size < MouseMove.ALL.size) {
            return OrbitChecks.ALL.forEach { book.measured(it, null, "The frames with the mouse are not all there.") }
        }
        val late = turns(1)
        val reactions = if (isLate(turns, late)) late.also { book.note("The camera follows the mouse one frame late.") } else turns
        val turning = reactions.filter { it.turn.angle > TURNED }
        val sideways = turning.filter { it.move.isSideways() }
        if (sideways.isEmpty()) return missing(reactions)
        book.measured(Check.ORBIT, 0.0, "The camera turns ${if (sideways.all { it.move.alt }) "while Alt is held" else "with the mouse"}.")
        val place = Gaze.fixed(timeline)
        val isTilted = place == null && OrbitAxis(book).judge(turning.map { it.turn }, sideways.map { it.turn })
        OrbitPivot(timeline, book).run { if (place == null) judge(turning, sideways) else looksAside(place) }
        val angles = reactions.map { it.move to if (place == null) it.turn.angle else it.turn.around }
        OrbitPace(profile.radiansPerPixel, book, isTilted).judge(angles)
        swingsBack()
        afterwards()
    }

    /** What happened up to each move, seen [lag] frames later. */
    private fun turns(lag: Int): List<Reaction> =
        MouseMove.ALL.mapNotNull { move ->
            val before = timeline.shot(Moment.entries[move.moment.ordinal - 1 + lag])
            val after = timeline.shot(Moment.entries[move.moment.ordinal + lag])
            if (before == null || after == null) null else Reaction(move, Turn(before, after))
        }

    private fun isLate(
        turns: List<Reaction>,
        late: List<Reaction>,
    ): Boolean {
        val still = turns.none { it.move.isSideways() && it.turn.angle > TURNED }
        // The longest way of all tells a camera that is late from one that turns with the mouse's way down.
        val answers = late.filter { it.move.isSideways() && !it.move.alt }.map { it.turn.angle > TURNED }
        if (answers.distinct().size > 1) return false
        // After the last move the motorcycle drives.
        val undriven = late.filter { it.move != MouseMove.ALL.last() }
        return still && late.size == turns.size && undriven.any { it.move.isSideways() && it.turn.angle > TURNED && it.turn.tilt < UPRIGHT }
    }

    private fun missing(reactions: List<Reaction>) {
        val turnsMotorcycle = reactions.any { it.turn.motorcycleTurned > MOTORCYCLE_TURNED }
        val byHeight = reactions.filter { !it.move.first && it.move.x == 0.0 && it.move.y != 0.0 && it.turn.angle > TURNED }
        if (byHeight.isNotEmpty() && byHeight.all { it.turn.tilt < UPRIGHT }) return byHeightOnly()
        if (!turnsMotorcycle && reactions.any { it.turn.moved > TURNED }) return movedOnly()
        val what =
            if (turnsMotorcycle) {
                "The mouse turns the motorcycle, not the camera about it"
            } else {
                "The camera does not turn when the mouse moves, with or without Alt"
            }
        OrbitChecks.ALL.forEach { book.absent(it, "$what.") }
        // Where the mouse does something the orbit has been written, and one thing is wrong with it.
        val explains = if (turnsMotorcycle) OrbitChecks.ALL - Check.ORBIT else emptySet()
        book.found(Mistake.ORBIT_MISSING, 0.0, 1.0, what, explains = explains)
    }

    /** The camera does react, in a way that has no name. */
    private fun movedOnly() {
        (OrbitChecks.ALL - Check.ORBIT).forEach { book.measured(it, 0.0, "The camera does not turn: that costs at the orbit.") }
        book.measured(Check.ORBIT, 1.0, "The mouse moves the camera without turning it.")
    }

    /** The two coordinates of the mouse were exchanged. */
    private fun byHeightOnly() {
        (OrbitChecks.ALL - Check.ORBIT).forEach {
            book.measured(
                it,
                0.0,
                "The camera turns with the wrong coordinate: that costs at the orbit.",
            )
        }
        book.measured(Check.ORBIT, 1.0, "The camera turns to the side when the mouse moves up or down, and not when it moves to the side.")
        book.found(Mistake.UNKNOWN, 1.0, 1.0, "camera, when the mouse moves up or down")
    }

    /** A camera that is where it was before, as soon as the mouse moves straight down: the last difference was taken for the sum of all. */
    private fun swingsBack() {
        val moments = listOf(Moment.MOUSE_FIRST to Moment.MOUSE_DOWN, Moment.ALT_HELD to Moment.ALT_DOWN)
        for ((first, last) in moments) {
            val before = timeline.shot(first) ?: continue
            val aside = timeline.shot(Moment.entries[last.ordinal - 1]) ?: continue
            val after = timeline.shot(last) ?: continue
            if (Turn(before, aside).angle < TURNED || Turn(aside, after).angle < TURNED || Turn(before, after).angle > TURNED) continue
            book.measured(Check.ORBIT_FACTOR, 1.0, "The camera swings back as soon as the mouse moves straight up or down.")
            return book.found(Mistake.MOUSE_FACTOR, 0.0, 1.0, "the last movement in the place of all")
        }
    }

    /** What becomes of the turned camera when the motorcycle drives on. */
    private fun afterwards() {
        val start = timeline.shot(Moment.STEERED) ?: return
        val turned = timeline.shot(Moment.MOUSE_FAR) ?: return
        val driven = timeline.shot(Moment.MOUSE_DRIVEN) ?: return
        val kept = Turn(turned, driven)
        val back = Turn(start, driven)
        if (kept.angle > LOST && back.angle < LOST) book.note("Driving turns the camera back to where it was before the mouse moved.")
    }

    private fun MouseMove.isSideways() = !first && x != 0.0 && y == 0.0

    internal companion object {
        /** Radians. Float matrices turn by 1e-6 of themselves; a factor in degrees still turns by 1e-3 in 100 pixels. */
        const val TURNED = 1e-4
        private const val MOTORCYCLE_TURNED = 1e-3
        private const val UPRIGHT = 0.05
        private const val LOST = 1e-2
    }
}

/** The checks of task 4.5. */
internal object OrbitChecks {
    val ALL: Set<Check> = setOf(Check.ORBIT, Check.ORBIT_PIVOT, Check.ORBIT_HORIZON, Check.ORBIT_FACTOR, Check.ORBIT_START)
}
