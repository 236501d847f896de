package cga.grading.study

import org.joml.Vector3d

/**
 * The lights of a program and what its textures do for them.
 *
 * @param isPlaced whether what is taken for the diffuse term says where light comes from.
 */
internal class Lit(
    val probes: List<LightProbe>,
    val roles: TextureRoles?,
    val isPlaced: Boolean = true,
) {
    companion object {
        private const val TEXTURED = 0.5
        private const val APART = 1e-3

        /** View-space units: two lights are further from each other. */
        private const val NEAR = 1e-2

        private fun channel(
            box: BlackBox,
            slot: ActiveUniform,
            search: LightSearch,
        ) = if (slot in box.program.deep) HiddenLights.channel(box, slot, search.samples(LightSearch.FEW_DIRECTIONS)) else 0

        fun of(
            box: BlackBox,
            colors: ColorSlots,
            search: LightSearch,
        ): Lit {
            val probes = colors.lamps.map { LightProbe(box, it, colors, channel(box, it, search)) }
            val white = box.program.samplers.associate { it.name to 1.0 }
            val all =
                probes.asSequence().mapNotNull { probe ->
                    val points = search.litPoints(probe, white).ifEmpty { return@mapNotNull null }
                    Seen(probe, points, TextureRoles.of(probe, points, colors))
                }
            // What shines without any texture is a constant in a branch, and no light to learn from.
            val first = all.firstOrNull() ?: return Lit(probes, null)
            val seen = if (first.roles.untextured < TEXTURED) first else all.firstOrNull { it.roles.untextured < TEXTURED } ?: first
            shared(seen, white, box, colors, probes)?.let { return it }
            if (isPlaced(seen, search)) return Lit(probes, seen.roles)
            val isExchanged = isExchanged(seen, search)
            return Lit(probes, if (isExchanged) seen.roles.exchanged() else seen.roles, isPlaced = isExchanged)
        }

        /** The same without the highlights, where these have no texture of their own. */
        private fun shared(
            seen: Seen,
            white: Map<String, Double>,
            box: BlackBox,
            colors: ColorSlots,
            probes: List<LightProbe>,
        ): Lit? {
            if (seen.roles.diffuse != null && seen.roles.specular != null && seen.roles.untextured < APART) return null
            val matte = SharedMap.matte(seen.probe, seen.points, white, colors).ifEmpty { return null }
            val roles = TextureRoles.of(LightProbe(box, seen.probe.slot, colors, matte = matte), seen.points, colors)
            if (roles.diffuse == null || roles.specular != null) return null
            return Lit(probes.map { LightProbe(box, it.slot, colors, matte = matte) }, roles.shared())
        }

        /** False where there is a diffuse term whose directions meet nowhere. */
        private fun isPlaced(
            seen: Seen,
            search: LightSearch,
        ): Boolean {
            val roles = seen.roles
            if (roles.diffuse == null || roles.peak != Peak.DIFFUSE) return true
            val placed = search.place(seen.probe, seen.points, roles.onlyDiffuse)
            return placed != null && placed.error < Placement.ACCEPTED * 5
        }

        /**
         * Whether what looks like the diffuse term, a cosine without an exponent, is that with the half vector: the term with the exponent is
         * brightest where the normal points to the light.
         */
        private fun isExchanged(
            seen: Seen,
            search: LightSearch,
        ): Boolean {
            if (seen.roles.specular == null) return false

            fun place(
                texels: Map<String, Double>,
                peak: Peak,
            ) = HintPlacement.of(seen.probe, search.hints, seen.points, texels, peak)?.view
            val shining = place(seen.roles.onlyDiffuse, Peak.SPECULAR) ?: return false
            return (place(seen.roles.onlySpecular, Peak.POWER) ?: return false).distance(shining) < NEAR
        }

        private class Seen(
            val probe: LightProbe,
            val points: List<Vector3d>,
            val roles: TextureRoles,
        )
    }
}
