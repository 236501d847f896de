package cga.exercise.components.light

import org.joml.Vector2f
import kotlin.math.cos

/** Cosines of the cone in which a light is full, and of the one outside of which it is dark. */
data class Cone(val full: Float, val dark: Float) {
    val asVector get() = Vector2f(full, dark)

    companion object {
        /** All directions: no cosine is below -1. */
        val EVERYWHERE = Cone(-1f, -2f)

        fun ofDegrees(inner: Double, outer: Double) =
            Cone(cos(Math.toRadians(inner)).toFloat(), cos(Math.toRadians(outer)).toFloat())
    }
}
