package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Math.toRadians
import org.joml.Matrix4f

class TronCamera : Transformable(), ICamera {
    private val projektion = Matrix4f().setPerspective(toRadians(85.0f), 16.0f / 9.0f, 0.1f, 100.0f)

    override fun getCalculateViewMatrix(): Matrix4f {
        val von = getWorldPosition()
        val nach = von.sub(getWorldZAxis(), org.joml.Vector3f())
        return Matrix4f().setLookAt(von, nach, getWorldYAxis())
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = projektion

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("viewMatrix", getCalculateViewMatrix(), false)
        shader.setUniform("projMatrix", getCalculateProjectionMatrix(), false)
    }
}
