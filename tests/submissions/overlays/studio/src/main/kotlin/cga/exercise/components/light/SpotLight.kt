package cga.exercise.components.light

import cga.exercise.components.shader.UniformBlock
import org.joml.Matrix4f
import org.joml.Vector3f
import kotlin.math.cos

class SpotLight(position: Vector3f, lightColor: Vector3f, private val inner: Float, private val outer: Float) :
    PointLight(position, lightColor), ISpotLight {
    override val k = Vector3f(0.5f, 0.05f, 0.01f)

    override fun bind(block: UniformBlock, index: Int, viewMatrix: Matrix4f) {
        super.bind(block, index, viewMatrix)
        val start = index * BYTES
        block.put(start + 12, cos(inner))
        block.put(start + 28, cos(outer))
        block.put(start + 32, viewMatrix.transformDirection(getWorldZAxis().negate()).normalize())
        block.put(start + 44, 1.0f)
    }
}
