package cga.grading.study

import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.min

/** What is seen of a program before its lights are studied one by one. */
internal class Sight private constructor(
    val look: FirstLook,
    val colors: ColorSlots,
    val lit: Lit,
) {
    /** Whether there is a light, and nothing that tells where it comes from. */
    private val isOdd: Boolean get() = lit.roles != null && (lit.roles.diffuse == null || !lit.isPlaced)

    companion object {
        /**
         * What is seen of [clear] at [surface], and whether the shader adds something to the normals; [suns] finds suns among the colours of
         * a program.
         */
        fun of(
            clear: BlackBox,
            surface: List<Vector3d>,
            suns: (BlackBox, ColorSlots) -> Set<ActiveUniform>,
        ): Pair<Sight, Boolean> {
            val usual = seen(clear, surface, suns)
            // What a shader adds to normals (the translation of a 4 × 4 matrix) is nothing beside long ones.
            val long = if (usual.isOdd) seen(clear.withNormalLength(LONG), surface, suns) else usual
            if (!long.isOdd) return long to (long !== usual)
            // Cosines with normals that the model's scale made longer are cut off at 1.
            val scale = clear.spaces.modelView.scale()
            val unscaled = if (abs(scale - 1) > EVEN) seen(clear.withNormalLength(min(scale, 1 / scale)), surface, suns) else usual
            return (if (unscaled.isOdd) usual else unscaled) to false
        }

        private fun seen(
            box: BlackBox,
            surface: List<Vector3d>,
            suns: (BlackBox, ColorSlots) -> Set<ActiveUniform>,
        ): Sight {
            val look = FirstLook.of(box, surface)
            val samples = LightSearch(look.box, surface).samples(LightSearch.FEW_DIRECTIONS)
            val all = if (box.program.deep.isEmpty()) look.colors else HiddenLights.added(look.box, look.colors, samples)
            val colors = all.withSuns(suns(look.box, all))
            return Sight(look, colors, Lit.of(look.box, colors, look.search))
        }

        private const val EVEN = 1e-3
        private const val LONG = 1048576.0
    }
}
