package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

class TronCamera : Transformable(), ICamera {

    override fun getCalculateViewMatrix(): Matrix4f {
        //return getWorldModelMatrix().invert()
        // scale vom motorrad muss raus
        return getWorldModelMatrix().normalize3x3().invert()
    }

    override fun getCalculateProjectionMatrix(): Matrix4f = Matrix4f().perspective(1.5f, 16f / 9f, 0.1f, 100f)

    override fun bind(shader: ShaderProgram) {
        shader.setUniform("pm", getCalculateProjectionMatrix(), false)
    }
}
