package cga.grading.sheet4.scene

import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.Handlebar
import cga.grading.scene.Shot
import cga.grading.scene.Trial
import cga.grading.scene.translation
import cga.grading.scene.tryAll
import org.joml.Matrix3d
import org.joml.Vector3d
import org.joml.Vector3dc
import java.lang.Math.IEEEremainder
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2

/** Does the headlight point where the motorcycle goes, and a little down? */
internal class Aim(private val staging: Staging, private val isConeSent: Boolean) {
    private val timeline = staging.timeline

    fun axes(): List<Axis> {
        val spot = staging.roles.spot ?: return emptyList()
        val shots = if (spot.late) timeline.settledShots else timeline.laterShots
        val samples = samples(spot, shots)
        if (samples.isEmpty() && !isConeSent) return listOf(Axis.right(CHECK, 0.0, say("aim.with-cone")))
        if (samples.isEmpty() && !spot.isSpot) return listOf(Axis.open(CHECK, say("spot.uneven", spot.name)))
        if (samples.isEmpty()) return listOf(none(spot))
        val always = trial(samples)
        val straight = if (always.holding.isEmpty()) straight(spot, samples) else null
        val swings = straight?.let { Axis.note(say("aim.swings", spot.name)) }
        return listOfNotNull(axis(spot, samples, straight ?: always), swings)
    }

    private fun axis(spot: PlacedLight, samples: List<Pair<Shot, Vector3d>>, trial: Trial<Chain>): Axis {
        val held = trial.holding.firstOrNull()
        val aim = held?.hypothesis
        val place = spot.chain
        return when {
            held != null && aim == Chain.CHILD -> sign(spot, samples.first(), held.constant, held.residual)
            (aim == Chain.STATIC && place?.rides == false) || (aim == Chain.CONSTANT && spot.isOnCamera) ->
                Axis.right(CHECK, 0.0, say("aim.with-light", spot.name))
            aim == Chain.CONSTANT && place?.rides == false && isOfFirstPicture(samples.first().second) ->
                Axis.right(CHECK, 0.0, say("aim.sent-once", spot.name))
            else -> wrongSpace(spot, trial)
        }
    }

    private fun none(spot: PlacedLight) =
        Axis.right(CHECK, 1.0, say("aim.none", spot.name)).lacking(say("lack.direction", spot.name), Check.CONE)

    private fun samples(spot: PlacedLight, shots: List<Shot>) = shots.mapNotNull { shot ->
        val direction = spot.track.at(shot.moment)?.spot?.direction ?: return@mapNotNull null
        if (direction.isFinite && direction.length() > NONE) shot to direction.normalize(Vector3d()) else null
    }

    /** Whether [spot] is known to turn with the motorcycle by its direction. */
    fun turns(spot: PlacedLight): Boolean {
        val trial = trial(samples(spot, timeline.laterShots))
        return trial.residual(Chain.CHILD) <= HOLDS && trial.residual(Chain.STATIC) > HOLDS
    }

    private fun trial(samples: List<Pair<Shot, Vector3d>>): Trial<Chain> = tryAll(Chain.AIMS, samples, HOLDS, Chain::turn)

    /** What holds of a headlight on the handlebar, which turns with it, while it is straight: it may be in a wrong space besides. */
    private fun straight(spot: PlacedLight, samples: List<Pair<Shot, Vector3d>>): Trial<Chain>? {
        val steered = Moment.entries.filter { Key.LEFT in it.keys || Key.RIGHT in it.keys }.toSet()
        return listOf(Handlebar.aside(spot.track, timeline), steered)
            .filter { it.isNotEmpty() }
            .map { aside -> trial(samples.filter { (shot, _) -> shot.moment !in aside }) }
            .find { it.holding.isNotEmpty() }
    }

    /** Whether [direction], the same numbers in every picture, pointed forwards and down as the first camera saw it, and up by itself. */
    private fun isOfFirstPicture(direction: Vector3dc): Boolean {
        val first = timeline.shots.first()
        val world = Matrix3d(first.viewTurn).transpose().transform(Vector3d(direction))
        return direction.y() > LEVEL && world.y < 0 && ahead(first).all { it.dot(world) > BEHIND }
    }

    private fun wrongSpace(spot: PlacedLight, trial: Trial<Chain>): Axis {
        val error = trial.residual(Chain.CHILD)
        val best = trial.holding.firstOrNull() ?: trial.nearest?.takeIf { it.residual < TELLS * error }
        val what = best?.hypothesis?.let(::name) ?: say("aim.off", error)
        val text = say("aim.wrong", spot.name, what)
        val mistake = best?.hypothesis?.let(::mistake) ?: return Axis.right(CHECK, error, text)
        // Of a motorcycle that never turned nobody can say which of the two it was.
        val ties = trial.holding.map { it.hypothesis }.filter { it != Chain.CHILD }.map(::mistake).distinct() - mistake
        return Axis.wrong(CHECK, error, text, mistake, spot.name, best.residual, ties)
    }

    private fun mistake(aim: Chain) = if (aim.parent == Parent.WORLD) Mistake.SPOT_DIRECTION_LOCAL else Mistake.SPOT_DIRECTION_WORLD

    private fun name(aim: Chain) =
        say(
            when {
                aim == Chain.CONSTANT -> "aim.constant"
                aim == Chain.STATIC -> "aim.stays"
                aim.space == Space.RAW -> "aim.world"
                aim.space == Space.CAMERA -> "aim.camera-matrix"
                aim.space == Space.TWICE -> "aim.view-twice"
                else -> "aim.first-view"
            },
        )

    /** Where a headlight that turns with the motorcycle points: [local] in the motorcycle's space. */
    private fun sign(spot: PlacedLight, sample: Pair<Shot, Vector3d>, local: Vector3dc, residual: Double): Axis {
        val world = Matrix3d(sample.first.viewTurn).transpose().transform(Vector3d(sample.second))
        val forwards = ahead(sample.first).map { it.dot(world) }
        val isBackwards = forwards.isNotEmpty() && forwards.all { it < -BEHIND }
        val fault =
            when {
                isBackwards && world.y > 0 -> "aim.points.backwards-up"
                isBackwards -> "aim.points.backwards"
                world.y > LEVEL -> "aim.points.up"
                world.y > -LEVEL -> return Axis.wrong(CHECK, UNTILTED, say("aim.level", spot.name, world), Mistake.UNKNOWN, spot.name)
                else -> return Axis.right(CHECK, residual, say("aim.right", spot.name, world))
            }
        val radians = radians(local)
        val points = say(fault)
        return when {
            radians != null -> {
                val text = say("aim.radians", spot.name, world, points, radians)
                Axis.wrong(CHECK, 1.0, text, Mistake.UNKNOWN, spot.name)
            }
            abs(world.y) > STEEP -> {
                val along = say(if (world.y < 0) "aim.points.down" else "aim.points.up")
                Axis.wrong(CHECK, 1.0, say("aim.straight", spot.name, world, along), Mistake.UNKNOWN, spot.name)
            }
            else -> {
                val where = "${spot.name} points ${if (isBackwards) "backwards" else "up"}"
                Axis.wrong(CHECK, 1.0, say("aim.sign", spot.name, world, points), Mistake.SPOT_DIRECTION_SIGN, where, residual)
            }
        }
    }

    /** The usual number of degrees that as radians turns forwards into [local]; null where none does. */
    private fun radians(local: Vector3dc): Int? {
        if (abs(local.x()) > LEVEL * local.length()) return null
        val pitches = listOf(atan2(local.y(), -local.z()), atan2(local.y(), local.z()))
        return TILTS.flatMap { listOf(-it, it) }.find { turn -> pitches.any { abs(IEEEremainder(it - turn, 2 * PI)) < TURNED } }
    }

    /** Where the motorcycle goes, and where the camera looks: forwards by either is forwards. Unit vectors in the world. */
    private fun ahead(shot: Shot): List<Vector3d> {
        val looking = shot.motorcycle.translation().sub(shot.camera.translation())
        return listOfNotNull(looking, driving(shot)).map { it.setComponent(1, 0.0) }.filter { it.length() > NONE }.map { it.normalize() }
    }

    private fun driving(shot: Shot): Vector3d? {
        val before = timeline.shot(Moment.TIME_4) ?: return null
        val after = timeline.shot(Moment.DRIVEN) ?: return null
        val way = after.motorcycle.translation().sub(before.motorcycle.translation())
        return if (way.length() < NONE) null else shot.motorcycleTurn.transform(Matrix3d(before.motorcycleTurn).transpose().transform(way))
    }

    private companion object {
        val CHECK = Check.SPOT_DIRECTION

        /** Of a unit vector, which is radians. */
        const val HOLDS = 3e-3
        const val LEVEL = 1e-3
        const val TELLS = 0.1
        const val UNTILTED = 0.5
        const val NONE = 1e-6

        /** Degrees; one of them is met by chance by one direction in five hundred. */
        val TILTS = (1..20) + listOf(25, 30, 35, 40, 45, 60, 90)
        const val TURNED = 1e-4

        /** Sine of the angle to the ground: more than 64°. */
        const val STEEP = 0.9

        /** Cosine. */
        const val BEHIND = 0.02
    }
}
