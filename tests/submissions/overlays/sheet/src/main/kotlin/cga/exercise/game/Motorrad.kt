package cga.exercise.game

import cga.exercise.components.geometry.Renderable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f
import kotlin.math.sin

/** Das Motorrad mit seiner Farbe, die sich mit der Zeit aendert. */
class Motorrad(modell: Renderable) : Renderable(modell.meshes) {
    private val farbe = Vector3f(1.0f)

    init {
        scaleLocal(Vector3f(0.8f))
    }

    fun getFarbe(): Vector3f = Vector3f(farbe)

    fun faerben(t: Float) {
        farbe.x = 0.55f + 0.45f * sin(t)
        farbe.y = 0.55f + 0.45f * sin(t * 0.6f + 2.0f)
        farbe.z = 0.55f + 0.45f * sin(t * 1.4f + 1.0f)
    }

    fun fahren(tempo: Float, lenkung: Float, dt: Float) {
        rotateLocal(0.0f, lenkung * tempo * 0.25f * dt, 0.0f)
        translateLocal(Vector3f(0.0f, 0.0f, -tempo * dt))
    }

    override fun render(shaderProgram: ShaderProgram) {
        shaderProgram.setUniform("emissionFarbe", farbe)
        super.render(shaderProgram)
    }
}
