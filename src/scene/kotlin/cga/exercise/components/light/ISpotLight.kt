package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f

/** A light that shines into a cone. */
public interface ISpotLight {
    /** Sends what a point light sends, the cone, and the direction, all through [viewMatrix] (world space → view space). */
    public fun bind(
        shaderProgram: ShaderProgram,
        name: String,
        viewMatrix: Matrix4f,
    )
}
