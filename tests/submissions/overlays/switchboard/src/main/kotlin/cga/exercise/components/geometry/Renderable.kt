package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {
    /** Colours the emission, or is the colour itself where nothing is lit. */
    val tint = Vector3f(1.0f)

    fun render(shaderProgram: ShaderProgram, view: Matrix4f) {
        shaderProgram.setUniform("uModelView", Matrix4f(view).mul(getWorldModelMatrix()), false)
        shaderProgram.setUniform("uTint", tint)
        for (mesh in meshes) mesh.render(shaderProgram)
    }

    fun cleanup() {
        for (mesh in meshes) mesh.cleanup()
    }
}
