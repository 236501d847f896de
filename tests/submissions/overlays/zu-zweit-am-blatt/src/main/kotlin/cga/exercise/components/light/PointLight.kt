package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

open class PointLight(
    position: Vector3f,
    farbe: Vector3f,
    staerke: Float = 1f,
    daempfung: Vector3f = Vector3f(1f, 0.5f, 0.1f)
) : Transformable(), IPointLight {

    val quelle = LichtQuelle(farbe, staerke, daempfung)

    init {
        translateGlobal(position)
    }

    // name ist bei uns nur der Index, z.B. "[2]"
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        quelle.senden(shaderProgram, name)
    }

    // mit Position, die muss schon im Viewspace sein
    open fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        bind(shaderProgram, name)
        shaderProgram.setUniform("lampAt$name", ortImView(viewMatrix))
    }
}
