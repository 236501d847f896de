package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.shader.uniforms
import org.joml.Vector3f

class Renderable(val meshes: MutableList<Mesh> = mutableListOf()) : Transformable() {

    /** [tint] colours what the object emits (4.4). */
    fun render(shaderProgram: ShaderProgram, tint: Vector3f) {
        shaderProgram.uniforms {
            "modell" set getWorldModelMatrix()
            "toenung" set tint
        }
        meshes.forEach { it.render(shaderProgram) }
    }

    fun cleanup() = meshes.forEach { it.cleanup() }
}
