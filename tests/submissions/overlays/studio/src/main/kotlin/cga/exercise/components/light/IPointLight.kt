package cga.exercise.components.light

import cga.exercise.components.shader.UniformBlock
import org.joml.Matrix4f

interface IPointLight {
    fun bind(block: UniformBlock, index: Int, viewMatrix: Matrix4f)
}
