package cga.grading.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.findings.Check
import cga.grading.findings.Mistake

/** Are the lights there, and do they ride along? */
internal class LightJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val program: ProgramFacts,
    events: List<CapturedEvent>,
    private val book: Notebook,
) {
    private val overwritten = events.filter { it.kind == EventKind.UNIFORM_OVERWRITTEN }.map { it.text }.toSet()

    fun judge() {
        point()
        spot()
    }

    private fun point() {
        val own = roles.own
        if (own == null) {
            val idle = roles.idle
            roles.further.find { idle == null && it.last.placedBy in overwritten }?.let { return replaced(it) }
            val others =
                when {
                    idle != null -> "${idle.name} is sent, and no shader draws with it."
                    roles.further.isEmpty() -> "No point light shines."
                    else -> "Only ${names(roles.further)} shine, far from the motorcycle."
                }
            POINT.forEach { book.absent(it, others) }
            // What is sent has been written, and one thing is wrong with it.
            val explains = if (idle == null) null else POINT - Check.POINT_LIGHT + Check.ATTENUATION_POINT + Check.LIGHT_COLOR
            book.found(Mistake.LIGHT_MISSING, 0.0, 1.0, idle?.name ?: "point light", explains = explains)
            book.lacks("the point light", POINT + Check.ATTENUATION_POINT + Check.LIGHT_COLOR, setOf(Mistake.LIGHT_MISSING))
            return
        }
        if (own.isSpot && roles.crossed == null) {
            book.measured(Check.POINT_LIGHT, 1.0, "The light ${own.name} shines, but not to all sides.")
        } else {
            book.measured(Check.POINT_LIGHT, 0.0, "The light ${own.name} shines.")
        }
        rides(own, Check.POINT_LIGHT_CHILD, Mistake.LIGHT_NOT_CHILD)
        height(own)
    }

    /** The motorcycle's light is sent, and [other] after it under the same names. */
    private fun replaced(other: LightTrack) {
        val text = "${other.name} is sent twice before a draw, far from the motorcycle the second time; wanted: each light by itself."
        POINT.forEach { book.absent(it, text) }
        val explains = POINT + Check.ATTENUATION_POINT + Check.LIGHT_COLOR - Mistake.LIGHT_POSITION_OVERWRITTEN.check
        book.found(Mistake.LIGHT_POSITION_OVERWRITTEN, 0.0, 1.0, other.name, explains = explains)
    }

    private fun spot() {
        val spot = roles.spot
        if (spot == null) {
            val strange = (roles.further + listOfNotNull(roles.own)).find { it.name in program.strange && it.rides }
            val other = strange?.let { "${it.name} shines unevenly, and in no cone around a direction." }
                ?: program.lent.firstOrNull()?.let {
                    "No light with a cone shines in a colour of its own; $it is the colour of another light too."
                }
            if (other != null) return notAsMeant(other, strange)
            val text = roles.crossed?.run { "${coned.name} has the cone that ${headlight.name} was meant to have." }
            SPOT.forEach { book.absent(it, text ?: "No light with a cone shines.") }
            val explains = roles.crossed?.let { SPOT + Check.CONE_SPECULAR - Check.SPOT_LIGHT }
            book.found(Mistake.SPOT_MISSING, 0.0, 1.0, roles.crossed?.headlight?.name ?: "spotlight", explains = explains)
            book.lacks("the spotlight", SPOT + Check.CONE_SPECULAR, setOf(Mistake.SPOT_MISSING))
            return
        }
        book.measured(Check.SPOT_LIGHT, 0.0, "The spotlight ${spot.name} shines.")
        rides(spot, Check.SPOT_LIGHT_CHILD, Mistake.SPOT_NOT_CHILD)
    }

    /** Something of the headlight is to be seen, and what is wrong with it has no name. */
    private fun notAsMeant(
        text: String,
        strange: LightTrack?,
    ) {
        val home = if (strange == null) Check.SPOT_LIGHT else Check.CONE
        SPOT.forEach { book.measured(it, 1.0, text) }
        val explains = SPOT + setOf(Check.CONE_SPECULAR, Check.MORE_LIGHTS_SHADING) - home
        book.found(Mistake.UNKNOWN, 1.0, 1.0, strange?.name ?: "spotlight", explains = explains)
    }

    /** Whether [light] moves with the motorcycle, judged under the hypothesis about its space that holds: a wrong space costs elsewhere. */
    private fun rides(
        light: LightTrack,
        check: Check,
        mistake: Mistake,
    ) {
        val placed = light.placed
        if (!timeline.cast.driven || timeline.laterShots.size < 2) {
            book.measured(check, null, "The motorcycle was never driven, so nobody can see whether ${light.name} follows it.")
            return
        }
        val error = if (light.isOnCamera) 1.0 else notRiding(placed)
        book.measured(check, error, "${light.name}: ${way(light)}; wanted: moves with the motorcycle.")
        if (error > TELLING) {
            val residual = if (placed.place == Place.STATIC) placed.static else placed.fit
            book.found(mistake, residual, error, light.name)
        }
    }

    private fun way(light: LightTrack) =
        when {
            light.isOnCamera -> "is fixed to the camera"
            else -> light.placed.place?.text ?: "neither rides with the motorcycle nor stays in the world"
        }

    private fun notRiding(placed: Placed): Double =
        when (placed.place) {
            Place.CHILD -> if (placed.child <= Placed.HOLDS) placed.child else share(placed)
            Place.STATIC, Place.FOLLOWER -> share(placed)

            // A wrong space costs its own check, and what cannot be told is not held against it.
            else -> if (placed.place?.rides == false) 1.0 else 0.0
        }

    /** 0 when only riding along explains the places, 1 when only staying does. */
    private fun share(placed: Placed) = placed.child / (placed.child + placed.static + TINY)

    private fun height(light: LightTrack) {
        if (light.placed.place?.right != true) return
        val shot = timeline.laterShots.find { light.at(it.moment) != null } ?: return
        val ground = timeline.cast.ground?.of(shot.frame)?.let(::groundHeight) ?: return
        val above = light.at(shot.moment)?.let { shot.world(it).y - ground } ?: return
        if (above >= IN_GROUND) return
        book.spoilt(
            Check.POINT_LIGHT_CHILD,
            1.0,
            "${light.name} is ${above.text()} above the ground; wanted: more than $IN_GROUND, so that it can shine onto it.",
        )
        book.found(Mistake.LIGHT_IN_GROUND, 0.0, 1.0, light.name)
    }

    private fun names(lights: List<LightTrack>) = lights.joinToString { it.name }

    private companion object {
        val POINT = setOf(Check.POINT_LIGHT, Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION)
        val SPOT = setOf(Check.SPOT_LIGHT, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE, Check.ATTENUATION_SPOT)
        const val TELLING = 0.05
        const val TINY = 1e-12

        /** World units. */
        const val IN_GROUND = 0.02
    }
}
