package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

open class PointLight(position: Vector3f, lichtfarbe: Vector3f) : Transformable(), IPointLight {

    // eigene Kopie, damit niemand von aussen die Farbe verstellt
    private val farbe = Vector3f(lichtfarbe)

    // x = K_c, y = K_l, z = K_q (Tabelle 1)
    protected open val daempfung = Vector3f(1.0f, 0.5f, 0.1f)

    init {
        translateGlobal(position)
    }

    fun getLichtfarbe(): Vector3f = Vector3f(farbe)

    fun setLichtfarbe(neueFarbe: Vector3f) {
        farbe.set(neueFarbe)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(name + "Position", getWorldPosition())
        shaderProgram.setUniform(name + "Farbe", getLichtfarbe())
        shaderProgram.setUniform(name + "K", daempfung)
    }
}
