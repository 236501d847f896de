package cga.grading.scene

import cga.grading.capture.Moment
import org.joml.Vector3d

/**
 * Where a light turned out to be.
 *
 * @param place the hypothesis that holds, null when none does.
 * @param holding all that hold: a light on the axis that the camera turns about looks the same under several.
 * @param child what is left when it should ride along, see [Fit.residual]; [static] when it should stay; [wrong] the least of what is
 * left under all hypotheses that are right.
 * @param fit what is left under [place], with its constant [point].
 * @param late whether it only holds where nothing moved since the frame before.
 */
internal class Placed(
    val place: Place?,
    val holding: Set<Place>,
    val child: Double,
    val static: Double,
    val wrong: Double,
    val fit: Double,
    val point: Vector3d?,
    val late: Boolean,
) {
    companion object {
        val UNKNOWN = Placed(null, emptySet(), 1.0, 1.0, 1.0, 1.0, null, false)

        /** Relative. Matrices of floats that hundreds of updates were multiplied into are off by 1e-4. */
        const val HOLDS = 3e-3

        /** Finds the places of all [lights]; where several hypotheses hold for one, that which holds for most lights. */
        fun all(
            lights: List<LightTrack>,
            timeline: Timeline,
        ) {
            lights.forEach { it.placed = of(it, timeline, Space.VIEW) }
            val votes = Space.entries.associateWith { space -> lights.count { light -> light.placed.holding.any { it.space == space } } }
            val common = Space.entries.maxBy { votes.getValue(it) }
            if (common != Space.VIEW) lights.forEach { it.placed = of(it, timeline, common) }
        }

        private fun of(
            light: LightTrack,
            timeline: Timeline,
            common: Space,
        ): Placed {
            val always = of(light, timeline.laterShots, common, false)
            if (always.place?.right == true && always.fit <= HOLDS) return always
            val aside = Handlebar.aside(light, timeline)
            if (aside.isNotEmpty()) return of(light, timeline.laterShots.filter { it.moment !in aside }, common, false)
            if (always.place?.right == true || timeline.settledShots.none { it.moment >= Moment.MOUSE_FIRST }) return always
            val settled = of(light, timeline.settledShots, common, true)
            return if (settled.place?.right == true && settled.fit <= HOLDS) settled else always
        }

        private fun of(
            light: LightTrack,
            shots: List<Shot>,
            common: Space,
            late: Boolean,
        ): Placed {
            val fits = Place.entries.mapNotNull { place -> place.fit(light, shots)?.let { place to it } }.toMap()

            fun residual(place: Place) = fits[place]?.residual ?: 1.0
            val wrong = minOf(residual(Place.CHILD), residual(Place.STATIC), residual(Place.FOLLOWER))
            val best = fits.keys.minByOrNull(::residual)?.takeIf { residual(it) < TELLS * wrong || (it.right && wrong < NEAR) }
            val holding = fits.keys.filter { residual(it) <= HOLDS }
            val place = holding.find { it.space == common } ?: holding.firstOrNull() ?: best
            return Placed(
                place,
                holding.toSet(),
                residual(Place.CHILD),
                residual(Place.STATIC),
                wrong,
                place?.let(::residual) ?: 1.0,
                fits[place]?.point,
                late,
            )
        }

        /** A hypothesis that does not hold exactly still tells what is wrong when it explains nearly all. */
        private const val TELLS = 0.1
        private const val NEAR = 0.03
    }
}
