package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram

interface ISpotLight {
    // had a viewMatrix here, but the direction goes to view space in the shader like the position
    fun bind(shaderProgram: ShaderProgram, name: String)
}
