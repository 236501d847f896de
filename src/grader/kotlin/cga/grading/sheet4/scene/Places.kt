package cga.grading.sheet4.scene

import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.Shot
import cga.grading.scene.scale
import cga.grading.scene.stretch
import cga.grading.scene.text
import cga.grading.scene.unevenness
import org.joml.Matrix4d
import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.max

/** Do the positions of all lights and the view space belong together? */
internal class Places(private val staging: Staging) {
    private val timeline = staging.timeline
    private val roles = staging.roles

    fun axes(): List<Axis> {
        val sharing = staging.sharing
        val adrift = roles.all.filter(::wandersOff)
        val alone = roles.all - sharing?.lights.orEmpty().toSet() - adrift.toSet()
        return listOfNotNull(view(), sharing?.let(::shared), adrift(adrift)) + alone.map(::space)
    }

    private fun view(): Axis? {
        val view = timeline.laterShots.maxByOrNull { stretch(it.view) } ?: return null
        val error = stretch(view.view)
        if (error <= RIGID) return if (roles.own == null) null else Axis.right(CHECK, error, say("view.rigid"))
        val factor = view.view.scale()
        val isUndone = abs(factor * view.motorcycle.scale() - 1) < RIGID
        val text = if (isUndone) say("view.undone", factor, view.motorcycle.scale()) else say("view.stretched", factor)
        return Axis.wrong(CHECK, error, text, Mistake.VIEW_SCALED, "view matrix, factor ${factor.text()}", unevenness(view.view))
    }

    private fun shared(sharing: Sharing): Axis? =
        when (sharing.kind) {
            SharingKind.OVERWRITTEN ->
                Axis.wrong(CHECK, 1.0, say("place.overwritten", sharing.names), Mistake.LIGHT_POSITION_OVERWRITTEN, sharing.names)
            SharingKind.COPY -> {
                val (spot, point) = sharing.lights.sortedBy { !it.isSpot }
                val names = "${spot.name}, also ${point.name}"
                Axis.wrong(Check.SPOT_LIGHT, 1.0, say("spot.twice", spot.name, point.name), Mistake.UNKNOWN, names)
            }
            SharingKind.OTHER_PARENT -> null
        }

    /** Lights that are moved on by as much at each picture: all in the same way, which costs once. */
    private fun adrift(lights: List<PlacedLight>): Axis? {
        val first = lights.firstOrNull() ?: return null
        val check = mapOf(roles.own to CHECK, roles.spot to Check.SPOT_LIGHT_CHILD)[first] ?: Check.MORE_LIGHTS
        val names = lights.joinToString { it.name }
        return Axis.wrong(check, 1.0, say("place.wanders", names), Mistake.UNKNOWN, names)
    }

    private fun space(light: PlacedLight): Axis {
        val chain = light.chain
        return when {
            light.isOnCamera -> Axis.right(CHECK, 0.0, say("place.of", light.name, say("place.on-camera")))
            chain == null && light in roles.further && movesWithCamera(light) ->
                Axis.wrong(CHECK, light.wrong, say("place.with-camera", light.name), Mistake.UNKNOWN, light.name)
            isFree(light) -> Axis.right(CHECK, 0.0, say("place.free", light.name))
            chain == null -> Axis.right(CHECK, light.wrong, say("place.of", light.name, say("place.unknown")))
            (chain == Chain.CONSTANT && light.place?.run { constant.length() < AT_CAMERA } == true) || isAtCamera(light) -> nowhere(light)
            isBesideCamera(light) -> {
                val place = light.track.last.position
                Axis.wrong(CHECK, 1.0, say("place.beside-camera", light.name, place), Mistake.TO_LIGHT_WORLD, light.name, light.residual)
            }
            chain.isViewed -> Axis.right(CHECK, light.residual, say("place.of", light.name, chain.text))
            else -> notViewed(light, chain)
        }
    }

    private fun notViewed(light: PlacedLight, chain: Chain): Axis {
        val mistake = if (chain.space == Space.SCALED) Mistake.VIEW_SCALED else Mistake.TO_LIGHT_WORLD
        // Fixed to the camera, while others went through the view: it may also be the camera's child.
        val mayBeChild = chain == Chain.CONSTANT && roles.isRider(light) && roles.all.any { it.chain == Chain.STATIC }
        val child = if (light.isSpot) Mistake.SPOT_NOT_CHILD else Mistake.LIGHT_NOT_CHILD
        val text = say("place.not-viewed", light.name, chain.text)
        return Axis.wrong(CHECK, light.wrong, text, mistake, light.name, light.residual, if (mayBeChild) listOf(child) else emptyList())
    }

    /** Where no position arrives the light is at the camera. */
    private fun nowhere(light: PlacedLight) = Axis
        .wrong(CHECK, 1.0, say("place.nowhere", light.name), Mistake.TO_LIGHT_WORLD, light.name)
        .lacking(say("lack.position", light.name))

    /** Whether [light] flies about by itself, which is allowed. */
    private fun isFree(light: PlacedLight): Boolean {
        val moves = movesByItself(light)
        return (light.chain == null && light in roles.further) || ((light.chain?.isViewed ?: true) && !isHeld(light) && moves)
    }

    private fun isHeld(light: PlacedLight) = light.residual <= PlacedLight.HOLDS

    /** Whether [light] moves while the motorcycle stands: it hovers or circles, about a place of its own. */
    private fun movesByItself(light: PlacedLight): Boolean {
        val both = seen(light) { it.moment in Moment.SECOND..Moment.TIME_4 }
        val onMotorcycle = both.map { (shot, place) -> Matrix4d(shot.motorcycleFrame).invert().transformPosition(place, Vector3d()) }
        val seen = listOf(both.map { it.second }, onMotorcycle)
        return both.size > 2 && seen.all { places -> places.maxOf { it.distance(places[0]) } > MOVED }
    }

    /** Whether [light] goes about in the world while the mouse turns the camera, and rests in the pictures between. */
    private fun movesWithCamera(light: PlacedLight): Boolean {
        val places = seen(light) { it.moment in Moment.MOUSE_FIRST..Moment.MOUSE_FAR }
        if (places.size < 3 || movesByItself(light)) return false
        val way = MOVED * max(1.0, places[0].second.length())
        val homes = roles.all.mapNotNull { other -> other.track.at(places[0].first.moment)?.let(places[0].first::world) }
        // Lights that are sorted by their distance from the camera take each other's turns.
        if (places.all { (_, place) -> homes.any { it.distance(place) <= way } }) return false
        val (moved, still) = places.zipWithNext().partition { (_, now) -> now.first.moment.mouse != null }
        return moved.any { (a, b) -> a.second.distance(b.second) > way } && still.all { (a, b) -> a.second.distance(b.second) <= way }
    }

    /** Whether [light] goes on by the same way at each picture, however long after the one before, while the motorcycle stands. */
    private fun wandersOff(light: PlacedLight): Boolean {
        val places = seen(light, timeline.shots) { it.moment <= Moment.TIME_4 }
        val steps = places.zipWithNext { (_, before), (_, now) -> now.sub(before, Vector3d()) }
        val pauses = places.zipWithNext { (before, _), (now, _) -> now.frame.time - before.frame.time }
        return steps.size >= FEWEST && pauses.max() >= LONGER * pauses.min() &&
            steps[0].length() > WAY && steps.all { it.distance(steps[0]) < SAME_STEP * steps[0].length() }
    }

    private fun seen(light: PlacedLight, shots: List<Shot> = timeline.laterShots, isMeant: (Shot) -> Boolean) =
        shots.filter(isMeant).mapNotNull { shot -> light.track.at(shot.moment)?.let { shot to shot.world(it) } }

    /** A camera that never turns about the motorcycle hides whether positions went through the view; lights beside the camera tell. */
    private fun isBesideCamera(light: PlacedLight): Boolean {
        val shot = timeline.laterShots.lastOrNull { light.track.at(it.moment) != null } ?: return false
        val state = light.track.at(shot.moment) ?: return false
        val isHidden = light.chain == Chain.CHILD && light.holds(Chain.CONSTANT) && roles.all.none { it.chain == Chain.STATIC }
        return isHidden && state.position.length() < BESIDE * shot.world(state).distance(shot.motorcycle.getTranslation(Vector3d()))
    }

    private fun isAtCamera(light: PlacedLight) = isBesideCamera(light) && light.track.last.position.length() < AT_CAMERA

    private companion object {
        val CHECK = Check.POINT_LIGHT_POSITION

        /** Float matrices that hundreds of rotations were multiplied into stretch by 1e-4. */
        const val RIGID = 2e-3

        /** World units. */
        const val AT_CAMERA = 1e-3
        const val BESIDE = 0.6
        const val MOVED = 0.02

        /** World units: at 60 pictures a second faster than anybody lets a light fly; what is added by mistake is a whole place. */
        const val WAY = 0.3
        const val FEWEST = 3
        const val SAME_STEP = 2e-3
        const val LONGER = 1.5
    }
}
