package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(p: Vector3f, var c: Vector3f) : Transformable(), IPointLight {
    var k = Vector3f(1f, 0.5f, 0.1f)

    init {
        translateGlobal(p)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "p", v.transformPosition(getWorldPosition()))
        shaderProgram.setUniform(name + "c", c)
        shaderProgram.setUniform(name + "k", k)
    }

    companion object {
        // view matrix, wird in Scene.render gesetzt (im interface ist die beim pointlight nicht dabei)
        var v = Matrix4f()
    }
}
