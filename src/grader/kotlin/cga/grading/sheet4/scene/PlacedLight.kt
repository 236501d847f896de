package cga.grading.sheet4.scene

import cga.grading.capture.Moment
import cga.grading.scene.Handlebar
import cga.grading.scene.LightTrack
import cga.grading.scene.Shot
import cga.grading.scene.Timeline
import cga.grading.scene.Trial
import cga.grading.scene.Tried
import cga.grading.scene.tryAll

/**
 * A light and where it turned out to be.
 *
 * @param place the hypothesis about its place that holds, or that explains nearly all; null where none does.
 * @param late whether it only holds where nothing moved since the picture before.
 */
internal class PlacedLight(val track: LightTrack, private val trial: Trial<Chain>, val place: Tried<Chain>?, val late: Boolean) {
    val name: String get() = track.name
    val isSpot: Boolean get() = track.cone != null
    val chain: Chain? get() = place?.hypothesis

    /** Whether it is known to move with the motorcycle. */
    val rides: Boolean get() = chain?.rides == true

    /** Whether it is fixed to the camera, though what is sent went through the view matrix. */
    val isOnCamera: Boolean get() = chain == Chain.CONSTANT && track.last.isViewed && trial.holding.none { it.hypothesis.isViewed }

    /** What its place leaves unexplained, relative to its distance from the camera. */
    val residual: Double get() = place?.residual ?: 1.0

    /** The same of the nearest place that is in view space, whatever carries the light. */
    val wrong: Double get() = listOf(Chain.CHILD, Chain.STATIC, Chain.FOLLOWER).minOf(trial::residual)

    /** Whether it may be a light that stays in the world as well. */
    val mayStay: Boolean get() = trial.residual(Chain.STATIC) <= HOLDS

    /** 0 when only riding along explains the places, 1 when only staying does. */
    val share: Double get() = trial.residual(Chain.CHILD).let { it / (it + trial.residual(Chain.STATIC) + TINY) }

    fun holds(chain: Chain): Boolean = trial.residual(chain) <= HOLDS

    companion object {
        /** Relative. Matrices of floats that hundreds of updates were multiplied into are off by 1e-4. */
        const val HOLDS = 3e-3

        /** A hypothesis that does not hold exactly still tells what is wrong when it explains nearly all. */
        private const val TELLS = 0.1
        private const val NEAR = 0.03
        private const val TINY = 1e-12

        /** Places [lights]; where several hypotheses hold for one, that whose space holds for most lights. */
        fun all(lights: List<LightTrack>, timeline: Timeline): List<PlacedLight> {
            val seen = lights.map { it to seen(it, timeline) }
            val votes = Space.entries.associateWith { space ->
                seen.count { (_, it) -> it.second.holding.any { tried -> tried.hypothesis.space == space } }
            }
            val common = Space.entries.maxBy { votes.getValue(it) }
            return seen.map { (light, its) -> PlacedLight(light, its.second, chosen(its.second, common), its.first) }
        }

        /** Whether the light is late, and what was tried of it in all pictures or in those that tell. */
        private fun seen(light: LightTrack, timeline: Timeline): Pair<Boolean, Trial<Chain>> {
            val always = trial(light, timeline.laterShots)
            if (holdsViewed(always)) return false to always
            val aside = Handlebar.aside(light, timeline)
            if (aside.isNotEmpty()) return false to trial(light, timeline.laterShots.filter { it.moment !in aside })
            val settled = timeline.settledShots.takeIf { shots -> shots.any { it.moment >= Moment.MOUSE_FIRST } } ?: return false to always
            val atRest = trial(light, settled)
            val isLate = holdsViewed(atRest) && chosen(always, Space.VIEW)?.hypothesis?.isViewed != true
            return isLate to (if (isLate) atRest else always)
        }

        private fun holdsViewed(trial: Trial<Chain>) = trial.holding.any { it.hypothesis.isViewed }

        fun trial(light: LightTrack, shots: List<Shot>): Trial<Chain> {
            val samples = shots.mapNotNull { shot -> light.at(shot.moment)?.let { shot to it.position } }
            return tryAll(Chain.PLACES, samples, HOLDS, Chain::matrix)
        }

        private fun chosen(trial: Trial<Chain>, common: Space): Tried<Chain>? {
            val wrong = listOf(Chain.CHILD, Chain.STATIC, Chain.FOLLOWER).minOf(trial::residual)
            val nearly = trial.nearest?.takeIf { it.residual < TELLS * wrong || (it.hypothesis.isViewed && wrong < NEAR) }
            return trial.holding.find { it.hypothesis.space == common } ?: trial.holding.firstOrNull() ?: nearly
        }
    }
}
