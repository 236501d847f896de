package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    /** The emissive texture is multiplied by this (4.4). */
    var glowTint = Vector3f(1.0f)

    /**
     * All shading is done in view space, so the shader never needs the model matrix alone.
     */
    fun render(shaderProgram: ShaderProgram, viewMatrix: Matrix4f) {
        val modelToView = Matrix4f(viewMatrix).mul(getWorldModelMatrix())
        val normalToView = Matrix4f(modelToView).invert().transpose()
        shaderProgram.setUniform("modelToView", modelToView, false)
        shaderProgram.setUniform("normalToView", normalToView, false)
        shaderProgram.setUniform("glowTint", glowTint)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}
