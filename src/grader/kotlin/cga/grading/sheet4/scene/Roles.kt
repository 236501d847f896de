package cga.grading.sheet4.scene

import cga.grading.capture.Moment
import cga.grading.scene.LightTrack
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ProgramFacts
import cga.grading.scene.Timeline
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Which light is which.
 *
 * @param own the motorcycle's point light, or the light that was meant to be it.
 * @param spot the headlight; without a cone where its cone is never sent.
 * @param further all other point lights that shine.
 * @param unlit names of the lights that never do.
 * @param idle the motorcycle's point light where it is sent and no shader draws with it.
 * @param coned another light that has the cone which [meant], the headlight, was meant to have.
 */
internal class Roles(
    val own: PlacedLight?,
    val spot: PlacedLight?,
    val further: List<PlacedLight>,
    val unlit: Set<String> = emptySet(),
    val idle: PlacedLight? = null,
    val coned: PlacedLight? = null,
    val meant: PlacedLight? = null,
) {
    /** All that shine and have a part. */
    val all: List<PlacedLight> = listOfNotNull(own, spot) + further

    fun isRider(light: PlacedLight): Boolean = light === own || light === spot

    companion object {
        /** The roles in [timeline], as the shaders of [program] draw with them. */
        fun of(timeline: Timeline, program: ProgramFacts): Roles {
            val (shining, unlit) = LightTrack.all(timeline.frames).partition { it.shines }
            val lights = PlacedLight.all(shining, timeline)
            val cones = lights.filter { it.isSpot }
            // One kind of light for all: then each has a cone.
            val spots = if (cones.size > 1 && cones.size == lights.size) listOf(headlight(cones)) else cones
            val points = lights - spots.toSet()
            val idle = idle(timeline)
            val own = own(points, timeline).takeIf { idle == null || it?.rides == true }
            val others = points - setOfNotNull(own)
            // The headlight rides along too, though its cone is never sent or cannot be told.
            val mayHaveNone = spots.isEmpty() && timeline.cast.driven
            val bare = others.find { mayHaveNone && it.rides && (program.canCone || it.name in program.strange) }
            val spot = spots.find { it.rides } ?: spots.firstOrNull() ?: bare
            return uncrossed(
                Roles(own, spot, others - setOfNotNull(bare), unlit.map { it.name }.toSet(), idle.takeIf { own == null }),
                timeline,
            )
        }

        /** [roles], without a spotlight where the cone is another's than the headlight's. */
        private fun uncrossed(roles: Roles, timeline: Timeline): Roles = with(roles) {
            val cone = spot ?: return this
            val isFar = !cone.rides && distance(cone, timeline) > FAR_OFF * cameraDistance(timeline)
            val rest = further.find { it.rides }
            when {
                isFar && rest != null -> Roles(own, null, further - rest, unlit, idle, cone, rest)
                own != null && cone.rides && isHeadlight(own) && isPointLight(cone) ->
                    Roles(cone, null, further, unlit, idle, cone, own)
                else -> this
            }
        }

        private fun isHeadlight(light: PlacedLight) = light.rides && !light.track.changesColor && light.hasK(SceneProfile.SHEET.spotK)

        private fun isPointLight(light: PlacedLight) = light.track.changesColor && light.hasK(SceneProfile.SHEET.pointK)

        private fun PlacedLight.hasK(k: Vector3dc?) = k != null && track.last.k.distance(k) < SAME_K

        /** Of lights that all have cones the one that was meant to: it rides along, keeps its colour, and is the narrowest. */
        private fun headlight(cones: List<PlacedLight>): PlacedLight =
            cones.minWith(compareBy({ !it.rides }, { it.track.changesColor }, { it.track.cone?.outerAngle }))

        private fun own(points: List<PlacedLight>, timeline: Timeline): PlacedLight? {
            val near = { light: PlacedLight -> distance(light, timeline) }
            // Many may ride along; the motorcycle's colour tells which is meant, then how near it is.
            val riding = points.filter { it.rides }
            if (timeline.cast.driven && riding.isNotEmpty()) return riding.find { it.track.changesColor } ?: riding.minBy(near)
            val close = points.filter { near(it) <= MEANT * cameraDistance(timeline) && wandered(it, timeline) < WANDERS * near(it) }
            // One of many around the motorcycle is none of its own.
            val nearest = close.minByOrNull(near)?.takeUnless { light -> points.any { it !== light && near(it) < APART * near(light) } }
            return points.find { it.track.changesColor } ?: nearest
        }

        /** The motorcycle's light where it is sent and never drawn with: then another one is none that was meant to be it. */
        private fun idle(timeline: Timeline): PlacedLight? {
            val idle = LightTrack.all(timeline.frames, ObservedFrame::idle).filter { it.shines }
            return PlacedLight.all(idle, timeline).find { it.rides && !it.mayStay }
        }

        /** How far [light] goes in the world while the motorcycle stands. */
        private fun wandered(light: PlacedLight, timeline: Timeline): Double {
            val standing = timeline.shots.filter { it.moment in Moment.SECOND..Moment.TIME_4 }
            val places = standing.mapNotNull { shot -> light.track.at(shot.moment)?.let(shot::world) }
            return places.maxOfOrNull { it.distance(places[0]) } ?: 0.0
        }

        private fun cameraDistance(timeline: Timeline) = timeline.laterShots.firstOrNull()?.distance ?: 0.0

        /** From the motorcycle, before it is driven. */
        private fun distance(light: PlacedLight, timeline: Timeline): Double {
            val shot = timeline.laterShots.find { light.track.at(it.moment) != null } ?: return Double.POSITIVE_INFINITY
            val state = light.track.at(shot.moment) ?: return Double.POSITIVE_INFINITY
            return listOf(shot.world(state), Vector3d(state.position)).minOf { it.distance(shot.motorcycle.getTranslation(Vector3d())) }
        }

        private const val SAME_K = 1e-3

        /** Times the camera's distance: no headlight is sent from there by mistake. */
        private const val FAR_OFF = 2.0

        /** How many times further away than its own light all others are. */
        private const val APART = 1.5

        /** Times its distance: who goes that far about the world is no light of the motorcycle's. */
        private const val WANDERS = 0.5

        /** A light that stays in the world is taken for the motorcycle's where it is no further away than this many times the camera. */
        private const val MEANT = 3.0
    }
}
