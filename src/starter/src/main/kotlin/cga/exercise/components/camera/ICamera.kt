package cga.exercise.components.camera

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

interface ICamera {
    /** World space to view space. */
    fun getCalculateViewMatrix(): Matrix4f

    /** View space to clip space. */
    fun getCalculateProjectionMatrix(): Matrix4f

    /** Sends both to the shader. */
    fun bind(shader: ShaderProgram)
}
