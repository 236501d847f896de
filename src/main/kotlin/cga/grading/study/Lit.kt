package cga.grading.study

import org.joml.Vector3d

/** The lights of a program and what its textures do for them. */
internal class Lit(
    val probes: List<LightProbe>,
    val roles: TextureRoles?,
) {
    companion object {
        private const val TEXTURED = 0.5
        private const val APART = 1e-3

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
            val probes = colors.lights.map { LightProbe(box, it, colors, channel(box, it, search)) }
            val white = box.program.samplers.associate { it.name to 1.0 }
            val all =
                probes.asSequence().mapNotNull { probe ->
                    val points = search.litPoints(probe, white).ifEmpty { return@mapNotNull null }
                    Seen(probe, points, TextureRoles.of(probe, points, colors.flats + colors.factors))
                }
            // What shines without any texture is a constant in a branch, and no light to learn from.
            val first = all.firstOrNull() ?: return Lit(probes, null)
            val seen = if (first.roles.untextured < TEXTURED) first else all.firstOrNull { it.roles.untextured < TEXTURED } ?: first
            return shared(seen, white, box, colors, probes) ?: Lit(probes, seen.roles)
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
            val roles = TextureRoles.of(LightProbe(box, seen.probe.slot, colors, matte = matte), seen.points, colors.flats + colors.factors)
            if (roles.diffuse == null || roles.specular != null) return null
            return Lit(probes.map { LightProbe(box, it.slot, colors, matte = matte) }, roles.shared())
        }

        private class Seen(
            val probe: LightProbe,
            val points: List<Vector3d>,
            val roles: TextureRoles,
        )
    }
}
