package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.UniformBlock
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(position: Vector3f, var lightColor: Vector3f) : Transformable(), IPointLight {
    protected open val k = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    /** Writes the light as number [index] of the array in lights.glsl. */
    override fun bind(block: UniformBlock, index: Int, viewMatrix: Matrix4f) {
        val start = index * BYTES
        block.put(start, viewMatrix.transformPosition(getWorldPosition()))
        block.put(start + 16, lightColor)
        block.put(start + 44, 0.0f)
        block.put(start + 48, k)
    }

    companion object {
        const val BYTES = 64
        const val MAX = 16
    }
}
