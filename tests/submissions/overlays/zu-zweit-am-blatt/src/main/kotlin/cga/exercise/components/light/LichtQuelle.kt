package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f

/**
 * Was bei allen Lichtern gleich ist: Farbe, Staerke, Daempfung (Kc, Kl, Kq)
 */
class LichtQuelle(var farbe: Vector3f, var staerke: Float, var daempfung: Vector3f) {

    // Farbe mal Staerke, der Shader kennt nur das Produkt
    val leistung: Vector3f
        get() = Vector3f(farbe).mul(staerke)

    fun senden(shader: ShaderProgram, index: String) {
        shader.setUniform("lamps$index.power", leistung)
        shader.setUniform("lamps$index.fade", daempfung)
    }
}

// Position und Blickrichtung (-z) im Viewspace

fun Transformable.ortImView(sicht: Matrix4f): Vector3f = sicht.transformPosition(getWorldPosition())

fun Transformable.richtungImView(sicht: Matrix4f): Vector3f = sicht.transformDirection(getWorldZAxis().negate())
