package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Matrix4d
import org.joml.Vector3d

/** Does the camera turn about the motorcycle, and look at it? */
internal class OrbitPivot(
    private val timeline: Timeline,
    private val book: Notebook,
) {
    private val box = motorcycleBox()

    /** Of all that [turning] the camera did, and of what it did when the mouse moved [sideways]. */
    fun judge(
        turning: List<Reaction>,
        sideways: List<Reaction>,
    ) {
        // A camera that nods a little where it stands when the mouse moves up or down still has the motorcycle before it.
        val nods = turning.filter { it !in sideways && it.turn.moved < IN_PLACE * it.turn.angle }
        val isFree = nods.sumOf { it.turn.angle } < LITTLE
        val worst = (if (isFree) turning - nods.toSet() else turning).maxBy { it.turn.passesBy(box) }
        val error = worst.turn.passesBy(box)
        val turnedInPlace = sideways.all { it.turn.moved < IN_PLACE * it.turn.angle }
        if (turnedInPlace && book.has(Mistake.ORBIT_OWN_AXIS)) {
            return book.measured(Check.ORBIT_PIVOT, 0.0, "The camera turns on the spot about its own axis: that costs at the horizon.")
        }
        book.measured(
            Check.ORBIT_PIVOT,
            error,
            "The axis passes the motorcycle by at ${error.percent()} of the camera's distance; wanted 0 %.",
        )
        if (error <= NAMED) return
        val passing = sideways.maxBy { it.turn.passesBy(box) }.takeIf { it.turn.passesBy(box) > NAMED } ?: worst
        val (where, fit) = whichPivot(passing, turnedInPlace)
        book.found(Mistake.ORBIT_PIVOT, fit, error, where)
    }

    /** What the camera turns about, if it is a place with a name, and how far from that. */
    private fun whichPivot(
        reaction: Reaction,
        turnedInPlace: Boolean,
    ): Pair<String, Double> {
        if (turnedInPlace) return "the camera itself" to 0.0
        val shot = timeline.shot(reaction.move.moment) ?: return "unknown" to 1.0
        val pivot = reaction.turn.pivot()
        val motorcycle = shot.motorcycle.translation()
        val names =
            listOf(
                "the origin of the world" to Vector3d(),
                "the motorcycle's world position, taken in the motorcycle's own space" to
                    shot.motorcycle.transformPosition(motorcycle, Vector3d()),
                "where the motorcycle started" to (timeline.shots.first().motorcycle.translation()),
            )
        val (name, place) = names.minBy { (_, place) -> level(place).distance(level(pivot)) }
        val fit = level(place).distance(level(pivot)) / shot.distance
        return if (fit < SAME_PLACE) name to fit else "${pivot.text()}; the motorcycle is at ${motorcycle.text()}" to fit
    }

    private fun level(point: Vector3d) = Vector3d(point.x, 0.0, point.z)

    /** Where the camera goes along and always looks at [place] in the world. */
    fun looksAside(place: Vector3d) {
        val what = "looks at ${place.text()}"
        book.measured(Check.ORBIT_HORIZON, 0.0, "The camera turns as it looks aside: that costs at the pivot.")
        book.measured(Check.ORBIT_PIVOT, 1.0, "The camera goes with the motorcycle and always $what; wanted: at the motorcycle.")
        book.found(Mistake.ORBIT_PIVOT, 0.0, 1.0, what, explains = emptySet())
    }

    /** The box that the motorcycle fills in its own space, its origin included: the camera may turn about any point of it. */
    private fun motorcycleBox(): Bounds {
        val shot = timeline.laterShots.firstOrNull() ?: return Bounds(Vector3d(), Vector3d())
        val shown = timeline.cast.motorcycle?.of(shot.frame) ?: return Bounds(Vector3d(), Vector3d())
        val inItself = Matrix4d(shot.motorcycleFrame).invert().mul(shown.model)
        val box = bounds(ObservedObject(inItself, null, emptyList(), shown.vertices, shown.buffers))
        return if (box == null) Bounds(Vector3d(), Vector3d()) else Bounds(box.least.min(Vector3d()), box.most.max(Vector3d()))
    }

    private companion object {
        /** Radians. */
        const val LITTLE = 0.25

        /** Relative. */
        const val NAMED = 0.02
        const val IN_PLACE = 0.05
        const val SAME_PLACE = 0.1
    }
}
