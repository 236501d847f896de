package cga.exercise.components.light

import org.lwjgl.opengl.GL20.*

/** All lights one behind the other in one array, the spot light is the last. */
class LightBlock(private val points: List<PointLight>, private val spot: SpotLight) {

    fun upload(view: FloatArray) {
        val id = glGetInteger(GL_CURRENT_PROGRAM)
        val data = FloatArray(9 * (points.size + 1))
        for ((i, light) in points.withIndex()) light.pack(view).copyInto(data, 9 * i)
        spot.pack(view).copyInto(data, 9 * points.size)
        glUniform3fv(glGetUniformLocation(id, "lights"), data)
        glUniform1fv(glGetUniformLocation(id, "cone"), spot.packCone(view))
    }
}
