package cga.exercise.components.light

import cga.exercise.components.math.*
import kotlin.math.cos

/** Both angles in degrees, from the middle of the cone. */
class SpotLight(
    x: Float, y: Float, z: Float, rgb: FloatArray,
    private val innerDeg: Double, private val outerDeg: Double, downDeg: Double
) : PointLight(x, y, z, rgb) {
    override val k = floatArrayOf(0.5f, 0.05f, 0.01f)

    init {
        rotateLocal(rad(-downDeg).toFloat(), 0f, 0f)
    }

    /** direction in view space and the cosines: 5 floats */
    fun packCone(view: FloatArray): FloatArray {
        val world = fromJoml(getWorldModelMatrix())
        val dir = unit(apply(mul(view, world), floatArrayOf(0f, 0f, -1f), 0f))
        return dir + cos(rad(innerDeg)).toFloat() + cos(rad(outerDeg)).toFloat()
    }
}
