package cga.exercise.components.camera

import cga.exercise.components.shader.UniformBlock
import org.joml.Matrix4f

interface ICamera {
    fun getCalculateViewMatrix(): Matrix4f
    fun getCalculateProjectionMatrix(): Matrix4f
    fun bind(block: UniformBlock)
}
