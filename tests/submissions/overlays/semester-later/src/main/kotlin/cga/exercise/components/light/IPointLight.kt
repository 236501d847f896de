package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

interface IPointLight {
    // viewMatrix was added: the shader gets the positions in view space
    fun bind(shaderProgram: ShaderProgram, viewMatrix: Matrix4f)
}
