package cga.exercise.game

import org.joml.Vector3f

/** Fades from colour to colour, and from the last one to the first. */
class Palette(private val secondsPerColor: Float, private vararg val colors: Vector3f) {

    fun at(time: Float): Vector3f {
        val position = time / secondsPerColor
        val index = position.toInt()
        val from = colors[index % colors.size]
        val to = colors[(index + 1) % colors.size]
        return from.lerp(to, position - index, Vector3f())
    }
}
