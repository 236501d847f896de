package cga.grading.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Matrix4d
import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.max

/** Do the positions of all lights and the view space belong together? */
internal class PositionJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    events: List<CapturedEvent>,
    private val book: Notebook,
) {
    private val overwritten = events.filter { it.kind == EventKind.UNIFORM_OVERWRITTEN }.map { it.text }.toSet()
    private val lights = listOfNotNull(roles.own, roles.spot) + roles.further

    fun judge() {
        if (roles.own == null && lights.isEmpty()) return
        if (roles.own != null) book.measured(Check.POINT_LIGHT_POSITION, 0.0, "The lights' places agree with the view.")
        scaledView()
        overwritten()
        if (!book.has(Mistake.LIGHT_POSITION_OVERWRITTEN)) {
            lights.forEach(::space)
            if (lights.none { it.placed.place == Place.STATIC }) lights.forEach(::besideCamera)
        }
    }

    private fun scaledView() {
        val shot = timeline.laterShots.maxByOrNull { stretch(it.view) } ?: return
        val error = stretch(shot.view)
        if (error > RIGID) {
            val factor = shot.view.scale()
            val scale = shot.motorcycle.scale()
            val cause = if (abs(factor * scale - 1) < RIGID) ": the motorcycle's scale of ${scale.text()} undone" else ""
            book.spoilt(Check.POINT_LIGHT_POSITION, error, "The view matrix stretches lengths by ${factor.text()}; wanted 1$cause.")
            book.found(Mistake.VIEW_SCALED, unevenness(shot.view), error, "view matrix, factor ${factor.text()}")
        } else if (roles.own != null) {
            book.spoilt(Check.POINT_LIGHT_POSITION, error, "The lights' places agree with the view, which keeps lengths.")
        }
    }

    private fun space(light: LightTrack) {
        val placed = light.placed
        val place = placed.place
        if (light.isOnCamera) {
            book.note("${light.name} is fixed to the camera.")
        } else if (place == Place.SCALED_CHILD || place == Place.SCALED_STATIC) {
            book.spoilt(Check.POINT_LIGHT_POSITION, placed.wrong, "${light.name}: ${place.text}; wanted: view · world position.")
            book.found(Mistake.VIEW_SCALED, placed.fit, placed.wrong, light.name)
        } else if (place == null && light in roles.further && !movesByItself(light) && movesWithCamera(light)) {
            book.spoilt(Check.POINT_LIGHT_POSITION, placed.wrong, "${light.name} moves in the world when the camera turns.")
            book.found(Mistake.UNKNOWN, 1.0, placed.wrong, light.name)
        } else if ((place == null && light in roles.further) ||
            ((place?.right ?: true) && placed.fit > Placed.HOLDS && movesByItself(light))
        ) {
            // A light that flies about by itself is allowed.
            book.note("${light.name} neither stays nor moves with the motorcycle.")
        } else if (place == null) {
            book.spoilt(Check.POINT_LIGHT_POSITION, placed.wrong, "${light.name} is neither fixed in the world nor to the motorcycle.")
        } else if (place == Place.CONSTANT && placed.point != null && placed.point.length() < AT_CAMERA) {
            neverSent(light)
        } else if (!place.right) {
            book.spoilt(Check.POINT_LIGHT_POSITION, placed.wrong, "${light.name}: ${place.text}; wanted: view · world position.")
            // Fixed to the camera, while others went through the view: it may also be the camera's child.
            val isCameraChild = place == Place.CONSTANT && lights.any { it.placed.place == Place.STATIC } && light.isRider()
            val other = if (light.isSpot) Mistake.SPOT_NOT_CHILD else Mistake.LIGHT_NOT_CHILD
            book.found(Mistake.TO_LIGHT_WORLD, placed.fit, placed.wrong, light.name, if (isCameraChild) listOf(other) else emptyList())
        } else {
            book.spoilt(Check.POINT_LIGHT_POSITION, placed.fit, "${light.name}: ${place.text}.")
        }
    }

    /** Whether [light] moves while the motorcycle stands: it hovers or circles, about a place of its own. */
    private fun movesByItself(light: LightTrack): Boolean {
        val standing = timeline.laterShots.filter { it.moment in Moment.SECOND..Moment.TIME_4 }
        val both = standing.mapNotNull { shot -> light.at(shot.moment)?.let { shot to shot.world(it) } }
        val inWorld = both.map { it.second }
        val onMotorcycle = both.map { (shot, place) -> Matrix4d(shot.motorcycleFrame).invert().transformPosition(place, Vector3d()) }
        return inWorld.size > 2 && listOf(inWorld, onMotorcycle).all { places -> places.maxOf { it.distance(places[0]) } > MOVED }
    }

    /** Whether [light] goes about in the world while the mouse turns the camera, and rests in the pictures between. */
    private fun movesWithCamera(light: LightTrack): Boolean {
        val shots = timeline.laterShots.filter { it.moment in Moment.MOUSE_FIRST..Moment.MOUSE_FAR }
        val places = shots.mapNotNull { shot -> light.at(shot.moment)?.let { shot.moment to shot.world(it) } }
        if (places.size < 3) return false
        val way = MOVED * max(1.0, places[0].second.length())
        val homes = lights.mapNotNull { other -> other.at(shots[0].moment)?.let(shots[0]::world) }
        // Lights that are sorted by their distance from the camera take each other's turns.
        if (places.all { (_, place) -> homes.any { it.distance(place) <= way } }) return false
        val (moved, still) = places.zipWithNext().partition { (_, now) -> now.first.mouse != null }
        return moved.any { (a, b) -> a.second.distance(b.second) > way } && still.all { (a, b) -> a.second.distance(b.second) <= way }
    }

    private fun LightTrack.isRider() = this === roles.own || this === roles.spot

    private fun neverSent(light: LightTrack) {
        book.spoilt(Check.POINT_LIGHT_POSITION, 1.0, "${light.name} is at the camera in every frame: no position arrives.")
        book.lacks("the position of ${light.name}", setOf(Check.POINT_LIGHT_POSITION), setOf(Mistake.TO_LIGHT_WORLD))
        book.found(Mistake.TO_LIGHT_WORLD, 0.0, 1.0, light.name)
    }

    /** A camera that never turns about the motorcycle hides whether positions went through the view; lights beside the camera tell. */
    private fun besideCamera(light: LightTrack) {
        val shot = timeline.laterShots.lastOrNull { light.at(it.moment) != null } ?: return
        val state = light.at(shot.moment) ?: return
        if (light.placed.place != Place.CHILD || (Place.CONSTANT.fit(light, timeline.laterShots)?.residual ?: 1.0) > Placed.HOLDS) return
        val toMotorcycle = shot.world(state).distance(shot.motorcycle.translation())
        if (state.position.length() < AT_CAMERA) {
            neverSent(light)
        } else if (state.position.length() < BESIDE * toMotorcycle) {
            val text = "${light.name} is beside the camera at ${state.position.text()} in every frame: these are not numbers of view space."
            book.spoilt(Check.POINT_LIGHT_POSITION, 1.0, text)
            book.found(Mistake.TO_LIGHT_WORLD, light.placed.fit, 1.0, light.name)
        }
    }

    private fun overwritten() {
        for (i in lights.indices) {
            val same = lights.drop(i + 1).filter { together(lights[i], it) && isOneNumber(lights[i], it) && !isTwin(lights[i], it) }
            if (same.isEmpty()) continue
            if (same.all { isCopy(lights[i], it) } && (same + lights[i]).none { it.last.placedBy in overwritten }) {
                twice(lights[i], same.first())
                continue
            }
            if (same.all { onOther(lights[i], it) }) {
                notChild(lights[i], same.first())
                continue
            }
            val names = (same + lights[i]).joinToString(" and ") { it.name }
            book.spoilt(Check.POINT_LIGHT_POSITION, 1.0, "$names are at the same place in every frame; wanted: each at its own.")
            book.found(Mistake.LIGHT_POSITION_OVERWRITTEN, 0.0, 1.0, names)
            listOf(Mistake.LIGHT_NOT_CHILD, Mistake.SPOT_NOT_CHILD).forEach { if (book.has(it)) excuse(it, names) }
            return
        }
    }

    /** Whether one is a spotlight and the other the same light without its cone: a headlight that is in the list of point lights, too. */
    private fun isCopy(
        a: LightTrack,
        b: LightTrack,
    ): Boolean = a.isSpot != b.isSpot && timeline.isOneColor(a, b)

    private fun twice(
        a: LightTrack,
        b: LightTrack,
    ) {
        val (spot, point) = if (a.isSpot) a to b else b to a
        book.spoilt(Check.SPOT_LIGHT, 1.0, "${spot.name} shines once more without a cone, as ${point.name}; wanted: as a spotlight only.")
        book.found(Mistake.UNKNOWN, 1.0, 1.0, "${spot.name}, also ${point.name}")
    }

    /** Whether one position stands for both: not where each was sent by itself, by choice or because nobody ever moved either. */
    private fun isOneNumber(
        a: LightTrack,
        b: LightTrack,
    ): Boolean {
        if (!isSentApart(a, b)) return true
        return !isChosen(a, b) && listOf(a, b).any { !it.isUnmoved() }
    }

    private fun isSentApart(
        a: LightTrack,
        b: LightTrack,
    ): Boolean {
        val sent = listOf(a, b).map { it.last.placedBy }
        return sent.none { it == null || it in overwritten } && sent[0] != sent[1]
    }

    /** Whether [light], one of the motorcycle's, hangs on what carries [other] about, each sent by itself. */
    private fun onOther(
        light: LightTrack,
        other: LightTrack,
    ) = light.isRider() && other in roles.further && light.placed.place == null && isSentApart(light, other)

    private fun notChild(
        light: LightTrack,
        other: LightTrack,
    ) {
        val mistake = if (light.isSpot) Mistake.SPOT_NOT_CHILD else Mistake.LIGHT_NOT_CHILD
        book.measured(mistake.check, 1.0, "${light.name}: hangs on what carries ${other.name}; wanted: moves with the motorcycle.")
        book.found(mistake, 0.0, 1.0, light.name, explains = setOf(Check.POINT_LIGHT_POSITION))
    }

    /** Whether two further lights are one and the same: then one was sent for the other, and nothing of it overwritten. */
    private fun isTwin(
        a: LightTrack,
        b: LightTrack,
    ) = a in roles.further && b in roles.further && a.last.color.distance(b.last.color) <= SAME * a.brightest

    /** Whether the light is where what it hangs on is. */
    private fun LightTrack.isUnmoved() = placed.place?.right == true && placed.point?.let { it.length() < AT_ORIGIN } == true

    /**
     * Whether the motorcycle's two lights may be at one place because the student put them there: both ride along, each sent
     * by itself.
     */
    private fun isChosen(
        a: LightTrack,
        b: LightTrack,
    ): Boolean {
        if (!a.isRider() || !b.isRider() || !a.rides || !b.rides) return false
        book.note("${a.name} and ${b.name} are at the same place, each sent by itself.")
        return true
    }

    /** What follows from the overwritten position does not cost again. */
    private fun excuse(
        mistake: Mistake,
        names: String,
    ) {
        book.remove(mistake)
        book.measured(mistake.check, 0.0, "$names share a position: that costs there.")
    }

    private fun together(
        a: LightTrack,
        b: LightTrack,
    ): Boolean {
        val both = timeline.laterShots.map { a.at(it.moment)?.position to b.at(it.moment)?.position }
        return both.any { (p, q) -> p != null && q != null } &&
            both.all { (p, q) -> p == null || q == null || p.distance(q) <= SAME * max(1.0, p.length()) }
    }

    private companion object {
        /** Float matrices that hundreds of rotations were multiplied into stretch by 1e-4. */
        const val RIGID = 2e-3

        /** Relative to the distance from the camera: a few roundings of floats. */
        const val SAME = 2e-6

        /** World units. */
        const val AT_CAMERA = 1e-3
        const val AT_ORIGIN = 1e-3
        const val BESIDE = 0.6
        const val MOVED = 0.02
    }
}
