package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram

class Renderable : Transformable() {
    val meshes: MutableList<Mesh> = ArrayList<Mesh>()

    fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("uModel", getWorldModelMatrix(), false)
        for (i in 0 until meshes.size) {
            meshes.get(i).render(shaderProgram)
        }
    }

    fun cleanup() {
        for (i in 0 until meshes.size) {
            meshes.get(i).cleanup()
        }
    }
}
