package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/** MeshFilter + MeshRenderer */
class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    /** one color per object is enough, no need for a MaterialPropertyBlock */
    var emissionColor = Vector3f(1.0f)

    fun render(shaderProgram: ShaderProgram, view: Matrix4f) {
        val objectToWorld = localToWorldMatrix
        val normalMatrix = Matrix4f(view).mul(objectToWorld).invert().transpose()
        shaderProgram.setUniform("_ObjectToWorld", objectToWorld, false)
        shaderProgram.setUniform("_MatrixIT_MV", normalMatrix, false)
        shaderProgram.setUniform("_EmissionColor", emissionColor)
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() {
        meshes.forEach { it.cleanup() }
    }
}
