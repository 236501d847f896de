package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.math.*
import org.lwjgl.opengl.GL20.*
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/** Looks at the thing it follows from behind and above; all angles are degrees. */
class TronCamera(private val target: Transformable) {
    var orbitDeg = 0.0
    var heightDeg = 35.0
    var distance = 4.0
    private val fovDeg = 80.0

    private fun headingDeg(): Double {
        val back = target.getWorldZAxis()
        return deg(atan2(back.x.toDouble(), back.z.toDouble()))
    }

    private fun eye(center: FloatArray): FloatArray {
        val around = rad(headingDeg() + orbitDeg)
        val above = rad(heightDeg)
        return floatArrayOf(
            center[0] + (distance * sin(around) * cos(above)).toFloat(),
            center[1] + (distance * sin(above)).toFloat(),
            center[2] + (distance * cos(around) * cos(above)).toFloat()
        )
    }

    fun view(): FloatArray {
        val center = floats(target.getWorldPosition())
        center[1] += 0.5f
        return lookAt(eye(center), center, floatArrayOf(0f, 1f, 0f))
    }

    fun uploadProjection() {
        val id = glGetInteger(GL_CURRENT_PROGRAM)
        glUniformMatrix4fv(glGetUniformLocation(id, "P"), true, perspective(fovDeg, 16f / 9f, 0.1f, 100f))
    }
}
