package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f

class SpotLight : PointLight, ISpotLight {

    private var winkel: Vector2f

    constructor(lightPosition: Vector3f, lightCol: Vector3f, attParam: Vector3f, winkel: Vector2f) : super(lightPosition, lightCol, attParam) {
        this.winkel = winkel
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)
        val dir = getWorldZAxis().negate().mul(Matrix3f(viewMatrix))
        shaderProgram.setUniform(name + "Dir", dir)
        shaderProgram.setUniform(name + "Angle", winkel)
    }
}
