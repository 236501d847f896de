package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/** Anything that is drawn: meshes, a place in the world and the colour of its glow. */
open class Renderable(val meshes: MutableList<Mesh> = mutableListOf(), val glow: Vector3f = Vector3f(1.0f)) : Transformable() {
    var visible = true

    fun render(shader: ShaderProgram) {
        if (!visible) return
        shader.setUniform("model", getWorldModelMatrix(), false)
        shader.setUniform("glowColor", glow)
        for (mesh in meshes) mesh.render(shader)
    }

    fun cleanup() {
        for (mesh in meshes) mesh.cleanup()
    }
}
