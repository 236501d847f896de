package cga.exercise.components.light

import org.joml.Vector3f
import kotlin.math.floor

/** Hue in turns, so that 0, 1 and 2 are all red; a value over 1 is a brighter light. */
data class Hsv(val hue: Float, val saturation: Float = 1f, val value: Float = 1f) {

    fun toRgb(): Vector3f {
        val sector = (hue - floor(hue)) * 6f
        val f = sector - floor(sector)
        val p = value * (1f - saturation)
        val q = value * (1f - saturation * f)
        val u = value * (1f - saturation * (1f - f))
        return when (sector.toInt()) {
            0 -> Vector3f(value, u, p)
            1 -> Vector3f(q, value, p)
            2 -> Vector3f(p, value, u)
            3 -> Vector3f(p, q, value)
            4 -> Vector3f(u, p, value)
            else -> Vector3f(value, p, q)
        }
    }
}
