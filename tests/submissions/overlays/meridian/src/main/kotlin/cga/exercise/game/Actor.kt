package cga.exercise.game

import cga.exercise.components.geometry.Renderable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** Something to draw, and the colour in which it glows. */
class Actor(val renderable: Renderable, val glow: Vector3f) {

    fun draw(shader: ShaderProgram) {
        shader.setUniform("glow", glow)
        renderable.render(shader)
    }
}
