package cga.exercise.game

import org.joml.Vector3f
import kotlin.math.sin

/** A colour for the emission, which may depend on the time. */
sealed class Glow {
    abstract fun at(t: Float): Vector3f

    data class Steady(val color: Vector3f) : Glow() {
        override fun at(t: Float) = Vector3f(color)
    }

    /** Every channel has a speed of its own. */
    data class Waves(val red: Float, val green: Float, val blue: Float) : Glow() {
        override fun at(t: Float) = Vector3f(wave(red * t), wave(green * t + 2f), wave(blue * t + 4f))

        private fun wave(x: Float) = 0.5f + 0.45f * sin(x)
    }
}
