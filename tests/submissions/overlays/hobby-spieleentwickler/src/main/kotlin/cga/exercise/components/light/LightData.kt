package cga.exercise.components.light

import org.joml.Vector2f
import org.joml.Vector3f

/** K_c, K_l and K_q */
data class Falloff(val constant: Float, val linear: Float, val quadratic: Float) {
    val packed: Vector3f get() = Vector3f(constant, linear, quadratic)

    companion object {
        val POINT = Falloff(1.0f, 0.5f, 0.1f)
        val SPOT = Falloff(0.5f, 0.05f, 0.01f)
    }
}

/** cosines of the inner and of the outer angle */
data class Cone(val cosInner: Float, val cosOuter: Float) {
    val packed: Vector2f get() = Vector2f(cosInner, cosOuter)

    companion object {
        /** no cosine is ever below -2, so everything is inside: a point light */
        val EVERYWHERE = Cone(-2.0f, -3.0f)
    }
}
