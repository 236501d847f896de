package cga.grading.sheet4.scene

import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.scene.Bounds
import cga.grading.scene.Gaze
import cga.grading.scene.ObservedObject
import cga.grading.scene.Shot
import cga.grading.scene.Turn
import cga.grading.scene.bounds
import cga.grading.scene.text
import cga.grading.scene.translation
import org.joml.Matrix4d
import org.joml.Vector3d
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.max

/** Task 4.5: the mouse takes the camera about the motorcycle, with or without Alt, as the submission likes it. */
internal class Orbit(private val staging: Staging) {
    private val timeline = staging.timeline

    /** What each of [MouseMove.ALL] made of the camera. */
    private class Reaction(val move: MouseMove, val turn: Turn)

    /**
     * The camera's pose against the mouse, fitted.
     *
     * @param paced null where no rule explains the angles; [uneven] then are the angles a pixel of the moves to the side.
     */
    private class Fitted(val reactions: List<Reaction>, val paced: Paced?, val later: Turn?) {
        val turning = reactions.filter { it.turn.angle > TURNED }
        private val rule = paced?.rule

        /** What turned because of the way that the mouse went. */
        val answers =
            turning.filter { rule == null || rule.pixels[MouseMove.ALL.indexOf(it.move)] != 0.0 } - setOfNotNull(reactions.firstOrNull())
        val isByHeight get() = rule?.way == Way.HEIGHT
        val isLate get() = rule != null && rule.lag > 0
    }

    fun axes(): List<Axis> {
        if (isSwapped()) return swapped()
        val inSpace = reactions { _, at -> at.cameraInMotorcycle }
        if (inSpace.size < MouseMove.ALL.size) return CHECKS.map { Axis.open(it, say("orbit.no-frames")) }
        val fitted = fitted(inSpace)
        val sideways = fitted.reactions.filter { isSideways(it.move) }
        if (fitted.paced == null && sideways.none { it.turn.angle > TURNED }) return turnsNothing(fitted)
        return about(fitted)
    }

    private fun turnsNothing(fitted: Fitted): List<Axis> {
        val inWorld = fitted(reactions { before, at -> Matrix4d(before.motorcycleFrame).invert().mul(at.camera) })
        if (fitted.reactions.any { it.turn.motorcycleTurned > MOTORCYCLE_TURNED } && inWorld.answers.isNotEmpty()) {
            val text = say("orbit.turns-motorcycle")
            return about(inWorld).filter { it.measured?.check != Check.ORBIT } +
                Axis.wrong(Check.ORBIT, 1.0, text, Mistake.ORBIT_MISSING, MOTORCYCLE)
        }
        val isMoved = fitted.reactions.any { it.turn.moved > TURNED }
        val text = say(if (isMoved) "orbit.moved-only" else "orbit.none")
        val found = Axis.found(if (isMoved) Mistake.UNKNOWN else Mistake.ORBIT_MISSING, if (isMoved) CAMERA else NOTHING)
        return CHECKS.map { check -> Axis.absent(check, text, found.takeIf { check == Check.ORBIT }) }
    }

    /** What is said of a camera that turns. */
    private fun about(fitted: Fitted): List<Axis> {
        val place = Gaze.fixed(timeline)
        val axis = if (place == null) axis(fitted) else listOf(Axis.right(Check.ORBIT_HORIZON, 0.0, say("orbit.looks-aside-horizon")))
        val isTilted = axis.any { it.measured?.check == Check.ORBIT && it.mistake != null }
        val pivot = if (place == null) pivot(fitted, axis.any { it.mistake?.mistake == Mistake.ORBIT_OWN_AXIS }) else looksAside(place)
        val isCurved = isTilted || pivot.mistake != null
        val way = if (fitted.isByHeight) Axis.wrong(Check.ORBIT, 1.0, say("mouse.height"), Mistake.UNKNOWN, UP_OR_DOWN) else turns(fitted)
        val late = if (fitted.isLate) Axis.note(say("orbit.late")) else null
        return listOfNotNull(way, pivot, late, goesBack(fitted)) + axis + pace(fitted, isCurved)
    }

    private fun turns(fitted: Fitted) =
        Axis.right(Check.ORBIT, 0.0, say(if (fitted.answers.all { it.move.alt }) "orbit.turns-with-alt" else "orbit.turns"))

    /** Whether the camera's own matrix stands before the motorcycle's: child · parent, which turns it about the middle of the world. */
    private fun isSwapped(): Boolean {
        val shots = timeline.laterShots.filter { it.moment < MouseMove.ALL.first().moment }
        return shots.size > 2 && !areAlike(shots.map { it.cameraInMotorcycle }) && areAlike(shots.map(::swappedPose))
    }

    private fun swappedPose(shot: Shot) = Matrix4d(shot.camera).mul(Matrix4d(shot.motorcycleFrame).invert())

    private fun areAlike(poses: List<Matrix4d>) = poses.all { it.equals(poses[0], HOLDS * (1 + poses[0].translation().length())) }

    /** The orbit of a camera whose matrices are in the wrong order, with these exchanged. */
    private fun swapped(): List<Axis> {
        val fitted = fitted(reactions { _, at -> swappedPose(at) })
        val rest = if (fitted.answers.isEmpty()) turnsNothing(fitted) else about(fitted).filter { it.measured?.check != Check.ORBIT_PIVOT }
        return rest + Axis.wrong(Check.ORBIT_PIVOT, 1.0, say("orbit.swapped"), Mistake.UNKNOWN, CAMERA)
    }

    private fun reactions(pose: (Shot, Shot) -> Matrix4d): List<Reaction> =
        MouseMove.ALL.mapNotNull { move -> turn(move.moment, pose)?.let { Reaction(move, it) } }

    private fun turn(moment: Moment, pose: (Shot, Shot) -> Matrix4d): Turn? {
        val before = timeline.shot(Moment.entries[moment.ordinal - 1]) ?: return null
        return timeline.shot(moment)?.let { Turn(before, it, pose) }
    }

    private fun fitted(reactions: List<Reaction>): Fitted {
        val later = turn(Moment.MOUSE_DRIVEN) { _, at -> at.cameraInMotorcycle }
        if (reactions.isEmpty()) return Fitted(reactions, null, later)
        val reference = reactions.maxBy { if (isSideways(it.move)) it.turn.angle else 0.0 }.turn
        val axis = (if (reference.angle > TURNED) reference else reactions.maxBy { it.turn.angle }.turn).axis
        if (!axis.isFinite) return Fitted(reactions, null, later)
        val rolled = Paced.of(reactions.map { it.turn.about(axis) }, later?.about(axis), staging.profile.radiansPerPixel)
        // A camera that circles one place and looks at another goes round evenly and turns unevenly.
        val paced = rolled ?: Paced.of(reactions.map { it.turn.around }, later?.around, staging.profile.radiansPerPixel)
        return Fitted(reactions, paced.takeIf { reactions.any { it.turn.angle > TURNED } }, later)
    }

    /** About what kind of axis, and what the horizon does. */
    private fun axis(fitted: Fitted): List<Axis> {
        val answers = fitted.answers.map { it.turn }.ifEmpty { fitted.turning.map { it.turn } }
        val lying = answers.filter { minOf(it.tilt, it.fromOwnAxis) > PI / 4 }.maxByOrNull { it.tilt }
        if (lying != null) {
            val share = lying.tilt / (PI / 2)
            val text = say("orbit.lying", lying.tilt)
            return listOf(
                Axis.wrong(Check.ORBIT, share, text, Mistake.UNKNOWN, TO_THE_SIDE),
                Axis.right(Check.ORBIT_HORIZON, 0.0, say("orbit.lying-horizon")),
            )
        }
        val error = fitted.turning.maxOf { rolled(it.turn) }
        val text = say("orbit.horizon", error)
        if (error <= NAMED) return listOf(Axis.right(Check.ORBIT_HORIZON, error, text)) + listOfNotNull(tilted(answers))
        val own = answers.maxBy(::rolled)
        val isSide = rolled(own) > NAMED
        val where = if (isSide) CAMERA else UP_OR_DOWN
        val fit = if (isSide) own.fromOwnAxis / own.tilt else error
        return listOf(Axis.wrong(Check.ORBIT_HORIZON, if (isSide) rolled(own) else error, text, Mistake.ORBIT_OWN_AXIS, where, fit))
    }

    /** A camera that keeps looking at the motorcycle has a level horizon, whatever it circles about. */
    private fun tilted(answers: List<Turn>): Axis? {
        val error = answers.maxOf { it.rise / max(it.angle, LEAST_TURN) }
        return if (error <= NAMED) null else Axis.wrong(Check.ORBIT, error, say("orbit.rises"), Mistake.UNKNOWN, TO_THE_SIDE)
    }

    private fun rolled(turn: Turn) = turn.roll / max(turn.angle, LEAST_TURN)

    /** Does the camera turn about the motorcycle, and look at it? */
    private fun pivot(fitted: Fitted, isOwnAxis: Boolean): Axis {
        val box = motorcycleBox()
        // A camera that nods a little where it stands when the mouse moves up or down still has the motorcycle before it.
        val nods = (fitted.turning - fitted.answers.toSet()).filter { it.turn.moved < IN_PLACE * it.turn.angle }
        val isFree = nods.sumOf { it.turn.angle } < LITTLE
        val turning = (if (isFree) fitted.turning - nods.toSet() else fitted.turning).ifEmpty { fitted.turning }
        val worst = turning.maxBy { it.turn.passesBy(box) }
        val error = worst.turn.passesBy(box)
        val onTheSpot = fitted.answers.all { it.turn.moved < IN_PLACE * it.turn.angle }
        if (onTheSpot && isOwnAxis) return Axis.right(Check.ORBIT_PIVOT, 0.0, say("orbit.own-axis-pivot"))
        val text = say("orbit.pivot", error)
        if (error <= NAMED) return Axis.right(Check.ORBIT_PIVOT, error, text)
        val passing = fitted.answers.maxByOrNull { it.turn.passesBy(box) }?.takeIf { it.turn.passesBy(box) > NAMED } ?: worst
        val (where, fit) = if (onTheSpot) "the camera itself" to 0.0 else whichPivot(passing)
        return Axis.wrong(Check.ORBIT_PIVOT, error, text, Mistake.ORBIT_PIVOT, where, fit)
    }

    /** What the camera turns about, if it is a place with a name, and how far from that. */
    private fun whichPivot(reaction: Reaction): Pair<String, Double> {
        val shot = timeline.shot(reaction.move.moment) ?: return "unknown" to 1.0
        val pivot = reaction.turn.pivot()
        val motorcycle = shot.motorcycle.translation()
        val names =
            listOf(
                "the origin of the world" to Vector3d(),
                OWN_SPACE to shot.motorcycle.transformPosition(motorcycle, Vector3d()),
                "where the motorcycle started" to timeline.shots.first().motorcycle.translation(),
            )
        val (name, distance) = names.map { (name, place) -> name to hypot(place.x - pivot.x, place.z - pivot.z) }.minBy { it.second }
        val fit = distance / shot.distance
        return (if (fit < SAME_PLACE) name else "${pivot.text()}; the motorcycle is at ${motorcycle.text()}") to fit
    }

    /** Where the camera goes along and always looks at [place] in the world. */
    private fun looksAside(place: Vector3d): Axis =
        Axis.wrong(Check.ORBIT_PIVOT, 1.0, say("orbit.looks-aside", place), Mistake.ORBIT_PIVOT, "looks at ${place.text()}")

    /** The box that the motorcycle fills in its own space, its origin included: the camera may turn about any point of it. */
    private fun motorcycleBox(): Bounds {
        val nothing = Bounds(Vector3d(), Vector3d())
        val shot = timeline.laterShots.firstOrNull() ?: return nothing
        val shown = timeline.cast.motorcycle?.of(shot.frame) ?: return nothing
        val inItself = Matrix4d(shot.motorcycleFrame).invert().mul(shown.model)
        val box = bounds(ObservedObject(inItself, null, emptyList(), shown.vertices, shown.buffers)) ?: return nothing
        return Bounds(box.least.min(Vector3d()), box.most.max(Vector3d()))
    }

    /** How fast it turns, and whether it waits for the mouse to move. [isCurved] says that it circles or looks aside, which is uneven. */
    private fun pace(fitted: Fitted, isCurved: Boolean): List<Axis> {
        val expected = staging.profile.radiansPerPixel
        val paced = fitted.paced
        val resting = fitted.reactions.find { !it.move.isEvent && it.turn.angle > TURNED && !fitted.isLate }
        val wrongWay = paced?.rule?.way?.takeIf { it.mistake == Mistake.MOUSE_FACTOR }
        val pace = abs(paced?.pace ?: paces(fitted).minByOrNull { abs(it / (expected ?: it) - 1) } ?: 0.0)
        val error = if (expected == null) 0.0 else abs(pace / expected - 1)
        val figure = "${pace.text()} rad a pixel"
        val factor =
            when {
                resting != null -> factor(1.0, say("mouse.resting", resting.turn.angle, resting.move.moment), "turns while the mouse rests")
                wrongWay != null -> factor(1.0, say(wrongWay.key), wrongWay.where)
                paced == null && isCurved -> Axis.right(Check.ORBIT_FACTOR, 0.0, say("mouse.curved"))
                paced == null -> factor(1.0, say("mouse.uneven", paces(fitted).map(::pace)), figure)
                error > NAMED && expected != null -> factor(error, say("mouse.factor", pace, expected), figure)
                else -> Axis.right(Check.ORBIT_FACTOR, error, say("mouse.right", pace))
            }
        return listOf(factor, start(fitted, pace))
    }

    private fun factor(error: Double, text: Message, where: String) =
        Axis.wrong(Check.ORBIT_FACTOR, error, text, Mistake.MOUSE_FACTOR, where)

    private fun paces(fitted: Fitted): List<Double> {
        val xs = MouseMove.ALL.map { it.at.x }
        return fitted.reactions.filter { isSideways(it.move) && it.turn.angle > TURNED }.map {
            val i = MouseMove.ALL.indexOf(it.move)
            it.turn.angle / abs(xs[i] - xs[i - 1])
        }
    }

    private fun start(fitted: Fitted, pace: Double): Axis {
        val first = fitted.reactions.first()
        val rule = fitted.paced?.rule
        val isJump = rule?.mistake == Mistake.MOUSE_JUMP
        if (first.turn.angle <= pace && !isJump) return Axis.right(Check.ORBIT_START, 0.0, say("mouse.waits"))
        val jump = if (first.turn.angle > pace) first else fitted.answers.firstOrNull() ?: first
        val pixels = jump.turn.angle / pace
        val corner = listOf(jump.move.at.x, jump.move.at.x + 1, hypot(jump.move.at.x, jump.move.at.y))
        val fit = corner.minOf { abs(pixels / it - 1) }
        val error = pixels / jump.move.at.x
        val where = "${pixels.text()} pixels' worth at ${jump.move.moment}"
        return Axis.wrong(Check.ORBIT_START, error, say("mouse.jumps", jump.turn.angle), Mistake.MOUSE_JUMP, where, fit)
    }

    /** What becomes of the turned camera when the motorcycle drives on. */
    private fun goesBack(fitted: Fitted): Axis? {
        val start = timeline.shot(Moment.STEERED) ?: return null
        val driven = timeline.shot(Moment.MOUSE_DRIVEN) ?: return null
        val isBack = (fitted.later?.angle ?: 0.0) > LOST && Turn(start, driven).angle < LOST && !fitted.isLate
        return if (isBack) Axis.note(say("orbit.driving-turns-back")) else null
    }

    private fun isSideways(move: MouseMove): Boolean {
        val before = MouseMove.ALL.getOrNull(MouseMove.ALL.indexOf(move) - 1) ?: return false
        return move.at.x != before.at.x && move.at.y == before.at.y
    }

    /** A number by itself: a list of numbers is a vector. */
    private fun pace(radians: Double) = say("mouse.pace", radians)

    companion object {
        private const val MOTORCYCLE = "The mouse turns the motorcycle, not the camera about it"
        private const val OWN_SPACE = "the motorcycle's world position, taken in the motorcycle's own space"
        private const val CAMERA = "camera"
        private const val UP_OR_DOWN = "camera, when the mouse moves up or down"
        private const val TO_THE_SIDE = "camera, when the mouse moves to the side"
        private const val NOTHING = "The camera does not turn when the mouse moves, with or without Alt"
        val CHECKS: Set<Check> = setOf(Check.ORBIT, Check.ORBIT_PIVOT, Check.ORBIT_HORIZON, Check.ORBIT_FACTOR, Check.ORBIT_START)

        /** Radians. Float matrices turn by 1e-6 of themselves; a factor in degrees still turns by 1e-3 in 100 pixels. */
        private const val TURNED = 1e-4
        private const val MOTORCYCLE_TURNED = 1e-3
        private const val LEAST_TURN = 1e-2
        private const val LITTLE = 0.25
        private const val LOST = 1e-2

        /** Of matrices, relative to distances. */
        private const val HOLDS = 3e-3

        /** Relative. */
        private const val NAMED = 0.02
        private const val IN_PLACE = 0.05
        private const val SAME_PLACE = 0.1
    }
}
