package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector2f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(
    pos: Vector3f,
    farbe: Vector3f,
    private val innen: Float,
    private val aussen: Float
) : PointLight(pos, farbe, Vector3f(0.5f, 0.05f, 0.01f)), ISpotLight {

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        // Richtung: negative z-Achse im Viewspace
        val richtung = Vector4f(getWorldZAxis().negate(), 0.0f)
        viewMatrix.transform(richtung)
        with(shaderProgram) {
            setUniform(name + "Pos", getWorldPosition())
            setUniform(name + "Farbe", farbe)
            setUniform(name + "Att", att)
            setUniform(name + "Richtung", Vector3f(richtung.x, richtung.y, richtung.z))
            setUniform(name + "Kegel", Vector2f(innen, aussen))
        }
    }
}
