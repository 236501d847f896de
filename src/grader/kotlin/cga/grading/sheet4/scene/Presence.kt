package cga.grading.sheet4.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.Shot
import cga.grading.scene.angle
import cga.grading.scene.groundHeight
import cga.grading.scene.translation
import org.joml.Matrix3d
import org.joml.Vector3d
import kotlin.math.abs

/** Are the motorcycle's two lights there, and does it carry them? */
internal class Presence(private val staging: Staging, private val aim: Aim) {
    private val timeline = staging.timeline
    private val roles = staging.roles

    fun axes(): List<Axis> = point() + spot()

    private fun point(): List<Axis> {
        val own = roles.own ?: return noPoint()
        val isAround = !own.isSpot || roles.coned != null
        val text = say(if (isAround) "light.shines" else "light.not-around", own.name)
        val shines = Axis.right(Check.POINT_LIGHT, if (isAround) 0.0 else 1.0, text)
        return listOfNotNull(shines, parent(own, Check.POINT_LIGHT_CHILD, Mistake.LIGHT_NOT_CHILD), height(own))
    }

    private fun noPoint(): List<Axis> {
        val other = roles.further.find { roles.idle == null && it.track.last.placedBy in staging.overwritten }
        val text =
            when {
                other != null -> say("light.sent-over", other.name)
                roles.idle != null -> say("light.idle", roles.idle.name)
                roles.further.isEmpty() -> say("light.none")
                else -> say("light.far", roles.further.joinToString { it.name })
            }
        val mistake = if (other == null) Mistake.LIGHT_MISSING else Mistake.LIGHT_POSITION_OVERWRITTEN
        val found = Axis.found(mistake, (other ?: roles.idle)?.name ?: "point light")
        val lack = say("lack.point")
        return listOf(Check.POINT_LIGHT, Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION).map { check ->
            val absent = Axis.absent(check, text, found.takeIf { check == Check.POINT_LIGHT })
            if (other == null) absent.lacking(lack, Check.ATTENUATION_POINT, Check.LIGHT_COLOR) else absent
        }
    }

    private fun spot(): List<Axis> {
        val spot = roles.spot ?: return noSpot()
        val shines = Axis.right(Check.SPOT_LIGHT, 0.0, say("spot.shines", spot.name))
        val own = roles.own
        // Both send where they are in their parent: one thing is wrong, and the direction shows that there is a parent.
        if (own?.chain == Chain.STATIC && spot.chain == Chain.STATIC && aim.turns(spot)) {
            return listOf(shines, Axis.right(Check.SPOT_LIGHT_CHILD, 0.0, say("parent.turns", spot.name, own.name)))
        }
        return listOf(shines, swapped(spot) ?: parent(spot, Check.SPOT_LIGHT_CHILD, Mistake.SPOT_NOT_CHILD))
    }

    private fun noSpot(): List<Axis> {
        val lent = staging.program.lent.firstOrNull()?.takeIf { roles.coned == null }
        // It shines in another light's colour: nobody can tell the two apart.
        if (lent != null) {
            val text = say("spot.lent", lent)
            val shared = Axis.wrong(Check.SPOT_LIGHT, 1.0, text, Mistake.UNKNOWN, lent, explains = setOf(Check.CONE_SPECULAR))
            return listOf(shared) + (SPOT - Check.SPOT_LIGHT).map { Axis.open(it, text) }
        }
        val text = if (roles.coned == null) say("spot.none") else say("spot.crossed", roles.coned.name, roles.meant?.name ?: "")
        val found = Axis.found(Mistake.SPOT_MISSING, roles.meant?.name ?: "spotlight")
        return SPOT.map { check ->
            Axis.absent(check, text, found.takeIf { check == Check.SPOT_LIGHT }).lacking(say("lack.spot"), Check.CONE_SPECULAR)
        }
    }

    /** Whether the motorcycle carries [light], whatever space its numbers are in. */
    private fun parent(light: PlacedLight, check: Check, mistake: Mistake): Axis {
        val sharing = staging.sharing?.takeIf { light in it.lights }
        if (sharing?.kind == SharingKind.OVERWRITTEN) return Axis.right(check, 0.0, say("parent.shared", sharing.names))
        if (sharing?.kind == SharingKind.OTHER_PARENT) {
            return Axis.wrong(check, 1.0, say("parent.other", light.name, sharing.lights[1].name), mistake, light.name)
        }
        if (!timeline.cast.driven || timeline.laterShots.size < 2) return Axis.open(check, say("parent.never-driven", light.name))
        val error = if (light.isOnCamera) 1.0 else notCarried(light)
        val way = if (light.isOnCamera) say("place.on-camera") else light.chain?.text ?: say("place.unknown")
        val text = say("parent.way", light.name, way)
        if (error <= TELLING) return Axis.right(check, error, text)
        return Axis.wrong(check, error, text, mistake, light.name, if (light.mayStay) 0.0 else light.residual)
    }

    /**
     * Whether its own matrix stands before the motorcycle's, child · parent, which turns it about the middle of the world: places and
     * directions then are the motorcycle's as a rigid whole.
     */
    private fun swapped(spot: PlacedLight): Axis? {
        val seen = timeline.laterShots.mapNotNull { shot ->
            val light = spot.track.at(shot.moment) ?: return@mapNotNull null
            val way = light.spot?.direction?.takeIf { it.isFinite } ?: return@mapNotNull null
            Posed(shot, shot.world(light), Matrix3d(shot.viewTurn).transpose().transform(Vector3d(way)))
        }
        if (spot.chain?.isViewed == true || seen.size < 2 || seen.all { it.turned(seen[0]) < TURNED }) return null
        val isRigid = seen.all { a -> seen.all { b -> a.isAsFarFrom(b) } }
        if (!isRigid) return null
        return Axis.wrong(Check.SPOT_LIGHT_CHILD, 1.0, say("parent.swapped", spot.name), Mistake.UNKNOWN, spot.name)
    }

    /** The headlight beside the motorcycle: where it is and points in the world. */
    private class Posed(private val shot: Shot, private val place: Vector3d, private val way: Vector3d) {
        private val ahead = shot.motorcycleTurn.transform(Vector3d(0.0, 0.0, -1.0))

        fun turned(other: Posed) = angle(ahead, other.ahead)

        fun isAsFarFrom(other: Posed): Boolean {
            val far = shot.motorcycle.translation().distance(other.shot.motorcycle.translation())
            val isAsFar = abs(place.distance(other.place) - far) < HOLDS * (1 + shot.distance)
            return isAsFar && abs(angle(way, other.way) - turned(other)) < HOLDS
        }
    }

    /** A wrong space costs its own check, and what cannot be told is not held against it. */
    private fun notCarried(light: PlacedLight): Double =
        when {
            light.chain?.isViewed != true -> if (light.chain?.rides == false) 1.0 else 0.0
            light.holds(Chain.CHILD) -> light.residual
            else -> light.share
        }

    private fun height(light: PlacedLight): Axis? {
        if (light.chain?.isViewed != true) return null
        val shot = timeline.laterShots.find { light.track.at(it.moment) != null } ?: return null
        val ground = timeline.cast.ground?.of(shot.frame)?.let(::groundHeight) ?: return null
        val above = light.track.at(shot.moment)?.let { shot.world(it).y - ground } ?: return null
        if (above >= IN_GROUND) return null
        return Axis.wrong(Check.POINT_LIGHT_CHILD, 1.0, say("light.in-ground", light.name, above), Mistake.LIGHT_IN_GROUND, light.name)
    }

    companion object {
        /** What cannot be right without a headlight. */
        val SPOT: Set<Check> = setOf(Check.SPOT_LIGHT, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE, Check.ATTENUATION_SPOT)
        private const val TELLING = 0.05

        /** Radians, and relative to distances. */
        private const val HOLDS = 3e-3
        private const val TURNED = 0.1

        /** World units. */
        private const val IN_GROUND = 0.02
    }
}
