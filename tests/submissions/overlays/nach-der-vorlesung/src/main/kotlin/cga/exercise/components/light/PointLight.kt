package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * @param lightCol Lichtfarbe L_i
 * @param att (K_c, K_l, K_q)
 */
open class PointLight(
    position: Vector3f,
    var lightCol: Vector3f,
    protected var att: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)
) : Transformable(), IPointLight {

    init {
        translateGlobal(position)
    }

    // fuer das struct im Shader
    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("$name.pos", getWorldPosition())
        shaderProgram.setUniform("$name.col", lightCol)
        shaderProgram.setUniform("$name.att", att)
    }

    // Aufgabe 4.6: uLightPos1, uLightPos2, ...
    fun bindNr(shaderProgram: ShaderProgram, nr: Int) {
        shaderProgram.setUniform("uLightPos$nr", getWorldPosition())
        shaderProgram.setUniform("uLightCol$nr", lightCol)
        shaderProgram.setUniform("uAtt$nr", att)
    }
}
