package cga.grading.scene

import cga.grading.capture.Moment
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
 * @param crossed where another light has the cone that the headlight was meant to have.
 */
internal class LightRoles(
    val own: LightTrack?,
    val spot: LightTrack?,
    val further: List<LightTrack>,
    val unlit: Set<String> = emptySet(),
    val idle: LightTrack? = null,
    val crossed: Crossed? = null,
) {
    /** The light that is [coned], and the one that was meant to be. */
    class Crossed(val coned: LightTrack, val headlight: LightTrack)

    /** These, without a spotlight where the cone is another's than the headlight's. */
    private fun uncrossed(timeline: Timeline): LightRoles {
        val coned = spot ?: return this
        val isOther = !coned.rides && distance(coned, timeline) > FAR_OFF * cameraDistance(timeline)
        val rest = further.find { it.rides }
        return when {
            isOther && rest != null -> LightRoles(own, null, further - rest, unlit, idle, Crossed(coned, rest))
            own != null && coned.rides && isHeadlight(own) && isPointLight(coned) ->
                LightRoles(coned, null, further, unlit, idle, Crossed(coned, own))
            else -> this
        }
    }

    private fun isHeadlight(light: LightTrack) = light.rides && !light.changesColor && light.hasK(TABLE_1.spotK)

    private fun isPointLight(light: LightTrack) = light.changesColor && light.hasK(TABLE_1.pointK)

    companion object {
        /** The roles in [timeline]; [canCone] says that the shaders could give a cone to a light that has none. */
        fun of(
            timeline: Timeline,
            canCone: Boolean = false,
        ): LightRoles {
            val (shining, unlit) = LightTrack.all(timeline.frames).partition { it.shines }
            Placed.all(shining, timeline)
            val cones = shining.filter { it.isSpot }
            // One kind of light for all: then each has a cone.
            val spots = if (cones.size > 1 && cones.size == shining.size) listOf(headlight(cones)) else cones
            val points = shining - spots.toSet()
            val idle = idle(timeline)
            val own = own(points, timeline).takeIf { idle == null || it?.rides == true }
            val others = points - setOfNotNull(own).toSet()
            // The headlight rides along too.
            val meant = if (canCone && spots.isEmpty() && timeline.cast.driven) others.find { it.rides } else null
            return LightRoles(
                own,
                spots.find { it.rides } ?: spots.firstOrNull() ?: meant,
                others - setOfNotNull(meant).toSet(),
                unlit.map { it.name }.toSet(),
                idle.takeIf { own == null },
            ).uncrossed(timeline)
        }

        /** Of lights that all have cones the one that was meant to: it rides along, keeps its colour, and is the narrowest. */
        private fun headlight(cones: List<LightTrack>): LightTrack =
            cones.minWith(compareBy({ !it.rides }, { it.changesColor }, { it.cone?.outerAngle }))

        private fun own(
            points: List<LightTrack>,
            timeline: Timeline,
        ): LightTrack? {
            val near = { light: LightTrack -> distance(light, timeline) }
            // Many may ride along; the motorcycle's colour tells which is meant, then how near it is.
            val riding = points.filter { it.rides }
            if (timeline.cast.driven && riding.isNotEmpty()) return riding.find { it.changesColor } ?: riding.minBy(near)
            val close = points.filter { near(it) <= MEANT * cameraDistance(timeline) && wandered(it, timeline) < WANDERS * near(it) }
            // One of many around the motorcycle is none of its own.
            val nearest = close.minByOrNull(near)?.takeUnless { light -> points.any { it !== light && near(it) < APART * near(light) } }
            return points.find { it.changesColor } ?: nearest
        }

        /** The motorcycle's light where it is sent and never drawn with: then another one is none that was meant to be it. */
        private fun idle(timeline: Timeline): LightTrack? {
            val idle = LightTrack.all(timeline.frames, ObservedFrame::idle).filter { it.shines }
            Placed.all(idle, timeline)
            return idle.find { it.rides && it.placed.static > Placed.HOLDS }
        }

        /** How far [light] goes in the world while the motorcycle stands. */
        private fun wandered(
            light: LightTrack,
            timeline: Timeline,
        ): Double {
            val standing = Moment.entries.filter { it in Moment.SECOND..Moment.TIME_4 }
            val places = standing.mapNotNull { timeline.world(light, it) }
            return places.maxOfOrNull { it.distance(places[0]) } ?: 0.0
        }

        private fun LightTrack.hasK(k: Vector3dc?) = k != null && last.k.distance(k) < SAME_K

        private fun cameraDistance(timeline: Timeline) = timeline.laterShots.firstOrNull()?.distance ?: 0.0

        /** From the motorcycle, before it is driven. */
        private fun distance(
            light: LightTrack,
            timeline: Timeline,
        ): Double {
            val shot = timeline.laterShots.find { light.at(it.moment) != null } ?: return Double.POSITIVE_INFINITY
            val state = light.at(shot.moment) ?: return Double.POSITIVE_INFINITY
            val places = listOf(shot.world(state), Vector3d(state.position))
            return places.minOf { it.distance(shot.motorcycle.translation()) }
        }

        private val TABLE_1 = SceneProfile.SHEET
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

/** Where the light really is at [moment] if its numbers are right, in world space. */
internal fun Timeline.world(
    light: LightTrack,
    moment: Moment,
): Vector3dc? = shot(moment)?.let { shot -> light.at(moment)?.let(shot::world) }
