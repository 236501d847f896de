package cga.grading.study

import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_BOOL
import org.lwjgl.opengl.GL33C.GL_INT

/**
 * Lights that shine evenly into all directions in a shader that could limit them to a cone.
 *
 * @param forgotten those that are no point lights: point lights of the same shader have no cone whatever is sent.
 * @param canCone whether any light could have a cone, while none has: in a shader with one kind of light nobody can say which was meant.
 */
internal class ConelessLights(
    val forgotten: List<LightModel>,
    val canCone: Boolean,
) {
    companion object {
        /** Of [lights], studied with [box]; [surface] are points on what is drawn. */
        fun of(
            box: BlackBox,
            colors: ColorSlots,
            surface: List<Vector3d>,
            roles: TextureRoles?,
            lights: List<LightModel>,
        ): ConelessLights {
            val none = ConelessLights(emptyList(), false)
            if (roles == null || roles.isShared) return none
            val (limited, all) = lights.partition { it.cone != null }
            // Of one array they are of one kind: those without a cone are point lights.
            val kinds = limited.map(::kind).toSet()
            val even = all.filter { kind(it) !in kinds }
            val zeros = SilentLights.zeros(box)
            val awake = SilentLights.awake(box, zeros)

            fun coned(changed: BlackBox): List<LightModel> {
                val study = LightStudy(LightSearch(changed, surface), roles)
                return even.filter { study.of(LightProbe(changed, it.probe.slot, colors))?.cone != null }
            }
            val off = switches(box)
            val byNumbers = if (zeros.any { it.components <= 2 }) coned(awake) else emptyList()
            val found = if (byNumbers.isEmpty() && limited.isEmpty() && off.isNotEmpty()) coned(awake.withValues(off)) else byNumbers
            return ConelessLights(if (found.size < even.size) found else emptyList(), limited.isEmpty() && found.isNotEmpty())
        }

        /** The name of [light]'s colour, elements of an array having one name; its own where it is in none. */
        private fun kind(light: LightModel) = light.probe.slot.name.replace(INDEX, "[]")

        private val INDEX = Regex("""\[\d+]""")

        /** Flags and whole numbers that are 0, each set to 1. */
        private fun switches(box: BlackBox): Map<String, FloatArray> =
            box.program.uniforms
                .filter { it.type == GL_BOOL || it.type == GL_INT }
                .filter { box.values[it.name]?.all { part -> part == 0f } ?: true }
                .associate { it.name to floatArrayOf(1f) }
    }
}
