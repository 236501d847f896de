package cga.grading.sheet4.scene

import kotlin.math.max

/** Why lights have one place. */
internal enum class SharingKind {
    /** One uniform for both, or one sent over the other. */
    OVERWRITTEN,

    /** A headlight that is in the list of point lights, too. */
    COPY,

    /** A light of the motorcycle's hangs on what carries another. */
    OTHER_PARENT,
}

/** Lights that are at one place in every picture although nobody chose that; the first is the one that should be elsewhere. */
internal class Sharing(val kind: SharingKind, val lights: List<PlacedLight>) {
    val names: String = lights.joinToString(" and ") { it.name }

    companion object {
        fun of(staging: Staging): Sharing? = Finder(staging).find()

        /** Relative to the distance from the camera: a few roundings of floats. */
        private const val SAME = 2e-6

        /** World units. */
        private const val AT_ORIGIN = 1e-3
    }

    private class Finder(private val staging: Staging) {
        private val roles = staging.roles

        fun find(): Sharing? =
            roles.all.indices.firstNotNullOfOrNull { i ->
                val light = roles.all[i]
                val same = roles.all.drop(i + 1).filter { areTogether(light, it) && !isChosen(light, it) && !areTwins(light, it) }
                if (same.isEmpty()) null else Sharing(kind(light, same), listOf(light) + same)
            }

        private fun kind(light: PlacedLight, same: List<PlacedLight>): SharingKind =
            when {
                same.all { isCopy(light, it) } && (same + light).none(::isOverwritten) -> SharingKind.COPY
                same.all { isOnOther(light, it) } -> SharingKind.OTHER_PARENT
                else -> SharingKind.OVERWRITTEN
            }

        private fun areTogether(a: PlacedLight, b: PlacedLight): Boolean {
            val both = staging.timeline.laterShots.mapNotNull { shot ->
                val one = a.track.at(shot.moment)?.position
                val other = b.track.at(shot.moment)?.position
                if (one == null || other == null) null else one to other
            }
            return both.isNotEmpty() && both.all { (p, q) -> p.distance(q) <= SAME * max(1.0, p.length()) }
        }

        /** Whether each was sent by itself, and put there by choice or because nobody ever moved either. */
        private fun isChosen(
            a: PlacedLight,
            b: PlacedLight,
        ) = isSentApart(a, b) && ((listOf(a, b).all { roles.isRider(it) && it.rides }) || listOf(a, b).all(::isUnmoved))

        private fun isSentApart(a: PlacedLight, b: PlacedLight): Boolean {
            val sent = listOf(a, b).map { it.track.last.placedBy }
            return sent.none { it == null } && listOf(a, b).none(::isOverwritten) && sent[0] != sent[1]
        }

        private fun isOverwritten(light: PlacedLight) = light.track.last.placedBy in staging.overwritten

        private fun isUnmoved(light: PlacedLight) =
            light.chain?.isViewed == true && light.place?.run { constant.length() < AT_ORIGIN } == true

        /** Whether two further lights are one and the same: then one was sent for the other, and nothing of it overwritten. */
        private fun areTwins(
            a: PlacedLight,
            b: PlacedLight,
        ) = a in roles.further && b in roles.further && a.track.last.color.distance(b.track.last.color) <= SAME * a.track.brightest

        private fun isCopy(a: PlacedLight, b: PlacedLight) = a.isSpot != b.isSpot && staging.isOneColor(a, b)

        private fun isOnOther(
            light: PlacedLight,
            other: PlacedLight,
        ) = roles.isRider(light) && other in roles.further && light.chain == null && isSentApart(light, other)
    }
}
