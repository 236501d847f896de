package cga.exercise.components.light

import cga.exercise.components.shader.UniformSender

interface IPointLight {
    fun bind(sender: UniformSender, index: Int)
}
