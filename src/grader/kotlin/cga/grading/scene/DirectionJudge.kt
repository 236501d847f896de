package cga.grading.scene

import cga.grading.capture.Key
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Matrix3d
import org.joml.Matrix3dc
import org.joml.Vector3d
import org.joml.Vector3dc
import java.lang.Math.IEEEremainder
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2

/** A hypothesis about the headlight's direction: [matrix] times something constant. */
internal enum class Aim(
    val mistake: Mistake?,
    val text: String,
    val matrix: (Shot) -> Matrix3dc,
) {
    CHILD(null, "turns with the motorcycle", { Matrix3d(it.viewTurn).mul(it.motorcycleTurn) }),
    WORLD(Mistake.SPOT_DIRECTION_WORLD, "is the world direction, without the view matrix", { it.motorcycleTurn }),
    CONSTANT(Mistake.SPOT_DIRECTION_LOCAL, "is the same numbers whatever the camera and the motorcycle do", { Matrix3d() }),
    STATIC(Mistake.SPOT_DIRECTION_LOCAL, "does not turn with the motorcycle", { it.viewTurn }),
    INVERSE(Mistake.SPOT_DIRECTION_WORLD, "went through the camera's matrix instead of its inverse", {
        Matrix3d(it.viewTurn).transpose().mul(it.motorcycleTurn)
    }),
}

/** Does the headlight point where the motorcycle goes, and a little down? */
internal class DirectionJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val book: Notebook,
) {
    private class Aimed(
        val direction: Vector3d,
        val residual: Double,
    )

    private class Sample(
        val shot: Shot,
        val direction: Vector3dc,
    )

    fun judge() {
        val spot = roles.spot ?: return
        val shots = if (spot.placed.late) timeline.settledShots else timeline.laterShots
        val samples =
            shots.mapNotNull { shot ->
                val direction = spot.at(shot.moment)?.spot?.direction?.let { Vector3d(it) }
                if (direction == null || !direction.isFinite || direction.length() < NONE) null else Sample(shot, direction.normalize())
            }
        if (samples.isEmpty()) return noDirection(spot)
        val always = aims(samples)
        val straight = if (holding(always) == null) straight(spot, samples) else null
        if (straight != null) book.note("The headlight ${spot.name} turns aside while the motorcycle is steered.")
        val aims = straight ?: always
        val aim = holding(aims)
        val child = aims.getValue(Aim.CHILD)
        when {
            aim == Aim.CHILD -> {
                sign(spot, samples.first(), child)
                if (aims.getValue(Aim.STATIC).residual > HOLDS) localPositions(spot)
            }
            (aim == Aim.STATIC && spot.placed.place?.rides == false) || (aim == Aim.CONSTANT && spot.isOnCamera) -> {
                book.measured(Check.SPOT_DIRECTION, 0.0, "The direction stays with the light, which does not ride along: that costs there.")
            }
            aim == Aim.CONSTANT && spot.placed.place?.rides == false && isOfFirstPicture(samples.first().direction) -> {
                book.measured(Check.SPOT_DIRECTION, 0.0, "The direction is never sent again, like the light's place: that costs there.")
            }
            else -> wrongSpace(spot, aim, aims)
        }
    }

    /** What holds of a headlight on the handlebar, which turns with it, while it is straight: it may be in a wrong space besides. */
    private fun straight(spot: LightTrack, samples: List<Sample>): Map<Aim, Aimed>? {
        val steered = Moment.entries.filter { Key.LEFT in it.keys || Key.RIGHT in it.keys }.toSet()
        return listOf(Handlebar.aside(spot, timeline), steered)
            .filter { it.isNotEmpty() }
            .map { aside -> aims(samples.filter { it.shot.moment !in aside }) }
            .find { holding(it) != null }
    }

    /** Whether [direction], the same numbers in every picture, pointed forwards and down as the first camera saw it, and up by itself. */
    private fun isOfFirstPicture(direction: Vector3dc): Boolean {
        val first = timeline.shots.first()
        val world = Matrix3d(first.viewTurn).transpose().transform(Vector3d(direction))
        return direction.y() > LEVEL && world.y < 0 && ahead(first).all { it.dot(world) > BEHIND }
    }

    private fun noDirection(spot: LightTrack) {
        book.measured(Check.SPOT_DIRECTION, 1.0, "${spot.name} has no direction: it is zero or no number.")
        book.lacks("the direction of ${spot.name}", setOf(Check.SPOT_DIRECTION, Check.CONE), emptySet())
    }

    /** A spotlight that turns with the motorcycle is its child; if it stays all the same, both lights send where they are in their parent. */
    private fun localPositions(spot: LightTrack) {
        val own = roles.own ?: return
        if (!book.has(Mistake.SPOT_NOT_CHILD) || !book.has(Mistake.LIGHT_NOT_CHILD)) return
        book.remove(Mistake.SPOT_NOT_CHILD)
        book.remove(Mistake.LIGHT_NOT_CHILD)
        val where = "${own.name}, ${spot.name}"
        book.found(Mistake.LIGHT_NOT_CHILD, own.placed.static, 1.0, where, explains = setOf(Check.SPOT_LIGHT_CHILD))
        book.note("${spot.name} turns with the motorcycle and does not move with it: $where send the position in their parent's space.")
    }

    private fun wrongSpace(
        spot: LightTrack,
        aim: Aim?,
        aims: Map<Aim, Aimed>,
    ) {
        val error = aims.getValue(Aim.CHILD).residual
        val best = aim ?: Aim.entries.minBy { aims.getValue(it).residual }.takeIf { aims.getValue(it).residual < TELLS * error }
        val what = best?.text ?: "is off by up to ${Math.toDegrees(error).text()}° from one that turns with the motorcycle"
        book.measured(Check.SPOT_DIRECTION, error, "The direction of ${spot.name} $what; wanted: turns with the motorcycle.")
        val mistake = best?.mistake ?: return
        // Of a motorcycle that never turned nobody can say which of the two it was.
        val same = Aim.entries.filter { aims.getValue(it).residual <= HOLDS }.mapNotNull { it.mistake }.distinct() - mistake
        book.found(mistake, aims.getValue(best).residual, error, spot.name, same)
    }

    private fun sign(
        spot: LightTrack,
        sample: Sample,
        child: Aimed,
    ) {
        val world = Matrix3d(sample.shot.viewTurn).transpose().transform(Vector3d(sample.direction))
        val forwards = ahead(sample.shot).map { it.dot(world) }
        val backwards = forwards.isNotEmpty() && forwards.all { it < -BEHIND }
        val what = "The direction of ${spot.name} is ${world.text()} in the world"
        val fault =
            when {
                backwards && world.y > 0 -> "backwards and up"
                backwards -> "backwards"
                world.y > LEVEL -> "up"
                else -> null
            }
        val turn = if (fault == null) null else radians(child.direction)
        if (fault != null && turn != null) {
            val why = "as if turned by $turn radians instead of degrees"
            book.measured(Check.SPOT_DIRECTION, 1.0, "$what: it points $fault, $why; wanted: forwards and down.")
            book.found(Mistake.UNKNOWN, child.residual, 1.0, spot.name)
        } else if (fault != null && abs(world.y) > STEEP) {
            val along = if (world.y < 0) "down" else "up"
            book.measured(Check.SPOT_DIRECTION, 1.0, "$what: it points straight $along; wanted: forwards and down.")
            book.found(Mistake.UNKNOWN, child.residual, 1.0, spot.name)
        } else if (fault != null) {
            book.measured(Check.SPOT_DIRECTION, 1.0, "$what: it points $fault; wanted: forwards and down.")
            book.found(Mistake.SPOT_DIRECTION_SIGN, child.residual, 1.0, "${spot.name} points $fault")
        } else {
            book.measured(Check.SPOT_DIRECTION, child.residual, "$what and turns with the motorcycle.")
            if (world.y > -LEVEL) book.note("The headlight ${spot.name} is level; the sheet wants it tilted down a little.")
        }
    }

    /** The usual number of degrees that as radians turns forwards into [local], a direction in the motorcycle's space; null where none does. */
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

    private fun aims(samples: List<Sample>): Map<Aim, Aimed> =
        if (samples.isEmpty()) emptyMap() else Aim.entries.associateWith { aimed(it, samples) }

    private fun holding(aims: Map<Aim, Aimed>): Aim? = aims.keys.find { aims.getValue(it).residual <= HOLDS }

    private fun aimed(
        aim: Aim,
        samples: List<Sample>,
    ): Aimed {
        val sum = Vector3d()
        for (sample in samples) sum.add(Matrix3d(aim.matrix(sample.shot)).transpose().transform(Vector3d(sample.direction)))
        return Aimed(sum, samples.maxOf { angle(aim.matrix(it.shot).transform(sum, Vector3d()), it.direction) })
    }

    private companion object {
        /** Radians. */
        const val HOLDS = 3e-3
        const val LEVEL = 1e-3
        const val TELLS = 0.1
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
