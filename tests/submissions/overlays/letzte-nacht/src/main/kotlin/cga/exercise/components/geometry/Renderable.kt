package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    //fun render(shaderProgram: ShaderProgram) {
    //    shaderProgram.setUniform("mM", getWorldModelMatrix(), false)
    //    for (m in meshes) m.render(shaderProgram)
    //}

    fun render(shaderProgram: ShaderProgram, v: Matrix4f) {
        val mv = Matrix4f(v).mul(getWorldModelMatrix())
        val nm = Matrix4f(mv).invert().transpose()
        shaderProgram.setUniform("mvM", mv, false)
        shaderProgram.setUniform("nM", nm, false)
        for (m in meshes) m.render(shaderProgram)
    }

    fun cleanup() {
        for (m in meshes) m.cleanup()
    }
}
