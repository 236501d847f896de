package cga.grading.sheet4.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.findings.Check
import cga.grading.scene.ProgramFacts
import cga.grading.scene.Timeline

/** All that the axes of the scene are judged from. */
internal class Staging(
    val timeline: Timeline,
    val roles: Roles,
    val profile: SceneProfile,
    val events: List<CapturedEvent>,
    val program: ProgramFacts,
) {
    /** Uniforms that were sent twice before a draw. */
    val overwritten: Set<String> = events.filter { it.kind == EventKind.UNIFORM_OVERWRITTEN }.map { it.text }.toSet()
    val sharing: Sharing? = Sharing.of(this)

    /** Whether [light] is where another one is that was sent over it. */
    fun isOverwritten(light: PlacedLight): Boolean = sharing?.run { kind == SharingKind.OVERWRITTEN && light in lights } ?: false

    /** The check that asks whether [light] is there. */
    fun presence(light: PlacedLight): Check =
        when (light) {
            roles.own -> Check.POINT_LIGHT
            roles.spot -> Check.SPOT_LIGHT
            else -> Check.MORE_LIGHTS
        }

    /** Whether two lights have the same colour in every picture: both are sent from the same numbers. */
    fun isOneColor(a: PlacedLight, b: PlacedLight): Boolean = timeline.frames.all { frame ->
        val (one, other) = listOf(a, b).map { it.track.at(frame.moment)?.color ?: return@all true }
        one.distance(other) <= SAME_COLOR * one.length()
    }

    private companion object {
        /** Relative. */
        const val SAME_COLOR = 1e-5
    }
}
