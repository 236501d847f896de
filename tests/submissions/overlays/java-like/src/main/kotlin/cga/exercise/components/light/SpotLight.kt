package cga.exercise.components.light

import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight : PointLight, ISpotLight {

    private val innerAngle: Float
    private val outerAngle: Float

    constructor(position: Vector3f, lightColor: Vector3f, innerAngle: Float, outerAngle: Float) : super(position, lightColor) {
        this.innerAngle = innerAngle
        this.outerAngle = outerAngle
        this.setAttenuation(0.5f, 0.05f, 0.01f)
    }

    override fun getWorldDirection(): Vector3f {
        val forward = Vector4f(0.0f, 0.0f, -1.0f, 0.0f)
        this.getWorldModelMatrix().transform(forward)
        return Vector3f(forward.x, forward.y, forward.z).normalize()
    }

    override fun getInnerAngle(): Float {
        return this.innerAngle
    }

    override fun getOuterAngle(): Float {
        return this.outerAngle
    }
}
