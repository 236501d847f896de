package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight : PointLight, ISpotLight {
    private var m_inner: Float = 0.0f
    private var m_outer: Float = 0.0f

    constructor(position: Vector3f, color: Vector3f, innerDegrees: Float, outerDegrees: Float) : super(position, color) {
        setAttenuation(0.5f, 0.05f, 0.01f)
        setCone(innerDegrees, outerDegrees)
    }

    fun setCone(innerDegrees: Float, outerDegrees: Float) {
        this.m_inner = Math.toRadians(innerDegrees.toDouble()).toFloat()
        this.m_outer = Math.toRadians(outerDegrees.toDouble()).toFloat()
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        // +z of the light points back to the light's source, the shader compares it with toLight
        val axis: Vector3f = viewMatrix.transformDirection(getWorldZAxis())
        shaderProgram.setUniform("uSpotAxis", axis)
        shaderProgram.setUniform("uSpotCosInner", cos(m_inner))
        shaderProgram.setUniform("uSpotCosOuter", cos(m_outer))
    }
}
