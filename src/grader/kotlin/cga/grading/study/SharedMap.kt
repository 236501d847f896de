package cga.grading.study

import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_INT

/** Both terms coloured by one texture, or the specular one by none: an exponent without end leaves the diffuse term alone. */
internal object SharedMap {
    /** The exponent, at a value that leaves nothing of the highlight of [probe]'s light as [texels] show it; empty where none does. */
    fun matte(
        probe: LightProbe,
        points: List<Vector3d>,
        texels: Map<String, Double>,
        colors: ColorSlots,
    ): Map<String, FloatArray> {
        val usual = TextureRoles.nonlinearity(probe, points, texels) ?: return emptyMap()
        if (usual < MIXED) return emptyMap()
        val box = probe.box
        return box.program.uniforms
            .filter { (it.type == GL_FLOAT || it.type == GL_INT) && (box.values[it.name]?.firstOrNull() ?: 0f) > LEAST }
            .map { mapOf(it.name to floatArrayOf(ENDLESS)) }
            .firstOrNull { (TextureRoles.nonlinearity(LightProbe(box, probe.slot, colors, matte = it), points, texels) ?: 1.0) < PURE }
            ?: emptyMap()
    }

    /** Above counts and switches. */
    private const val LEAST = 1.5f
    private const val ENDLESS = 1e6f
    private const val MIXED = 1e-2
    private const val PURE = 1e-3
}
