package cga.exercise.components.geometry

import cga.exercise.components.math.*
import cga.exercise.components.shader.ShaderProgram
import org.lwjgl.opengl.GL20.*

class Renderable(val meshes: MutableList<Mesh> = ArrayList()) : Transformable() {

    fun render(shaderProgram: ShaderProgram, view: FloatArray, glow: FloatArray) {
        val id = glGetInteger(GL_CURRENT_PROGRAM)
        val mv = mul(view, fromJoml(getWorldModelMatrix()))
        // the scale is the same in all directions, so the upper left part will do for the normals
        val nm = floatArrayOf(mv[0], mv[1], mv[2], mv[4], mv[5], mv[6], mv[8], mv[9], mv[10])
        glUniformMatrix4fv(glGetUniformLocation(id, "MV"), true, mv)
        glUniformMatrix3fv(glGetUniformLocation(id, "NM"), true, nm)
        glUniform3fv(glGetUniformLocation(id, "glow"), glow)
        for (mesh in meshes) mesh.render(shaderProgram)
    }

    fun cleanup() {
        for (mesh in meshes) mesh.cleanup()
    }
}
