package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

interface IPointLight {
    // geändert: Shader will alles im Viewspace, deshalb auch hier die ViewMatrix
    fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f)
}
