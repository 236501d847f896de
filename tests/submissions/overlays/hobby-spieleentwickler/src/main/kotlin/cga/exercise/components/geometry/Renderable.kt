package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.set
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    /** colour of the emissive map */
    var glow = Vector3f(1.0f)

    fun render(shader: ShaderProgram, view: Matrix4f) {
        val model = world
        shader["u_model"] = model
        shader["u_normalMat"] = Matrix4f(view).mul(model).normal(Matrix3f())
        shader["u_glow"] = glow
        meshes.forEach { it.render(shader) }
    }

    fun cleanup() = meshes.forEach { it.cleanup() }
}
