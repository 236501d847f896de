package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram

/** A light that shines evenly in every direction. */
public interface IPointLight {
    /** Sends position (world space), colour and attenuation to the members of the struct uniform [name]. */
    public fun bind(
        shaderProgram: ShaderProgram,
        name: String,
    )
}
