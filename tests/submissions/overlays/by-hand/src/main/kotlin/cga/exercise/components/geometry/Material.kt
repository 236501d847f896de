package cga.exercise.components.geometry

import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import org.joml.Vector2f
import org.lwjgl.opengl.GL20.*

class Material(
    var diff: Texture2D,
    var emit: Texture2D,
    var specular: Texture2D,
    var shininess: Float = 50.0f,
    var tcMultiplier: Vector2f = Vector2f(1.0f)
) {
    fun bind(shaderProgram: ShaderProgram) {
        val id = glGetInteger(GL_CURRENT_PROGRAM)
        val maps = arrayOf(diff, specular, emit)
        for (i in maps.indices) maps[i].bind(i)
        glUniform1iv(glGetUniformLocation(id, "maps"), intArrayOf(0, 1, 2))
        // x, y: tiling, z: shininess
        glUniform3fv(glGetUniformLocation(id, "surface"), floatArrayOf(tcMultiplier.x, tcMultiplier.y, shininess))
    }
}
