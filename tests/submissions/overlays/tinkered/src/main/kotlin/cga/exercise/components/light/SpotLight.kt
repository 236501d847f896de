package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.joml.Vector4f

class SpotLight(
    startPosition: Vector3f,
    lightColor: Vector3f,
    private val winkelInnen: Float,
    private val winkelAussen: Float,
    intensity: Float = 1.0f,
    schalter: Int = -1
) : PointLight(startPosition, lightColor, intensity, schalter), ISpotLight {

    init {
        // Tabelle 1
        kc = 0.5f
        kl = 0.05f
        kq = 0.01f
    }

    override fun bind(shaderProgram: ShaderProgram, name: String, viewMatrix: Matrix4f) {
        super.bind(shaderProgram, name)

        // Richtung = ein Punkt vor der Lampe minus die Lampe selbst
        val lampe = getWorldPosition()
        val davor = punktInDerWelt(Vector3f(0.0f, 0.0f, -1.0f))
        val r = davor.sub(lampe)
        r.normalize()

        // in View Space, 0 hinten weil Richtung
        val r4 = Vector4f(r.x, r.y, r.z, 0.0f)
        r4.mul(viewMatrix)
        val richtung = Vector3f(r4.x, r4.y, r4.z)
        richtung.normalize()

        shaderProgram.setUniform(name + "_richtung", richtung)
        shaderProgram.setUniform(name + "_innen", winkelInnen)
        shaderProgram.setUniform(name + "_aussen", winkelAussen)
    }
}
