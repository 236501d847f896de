package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * @param slot Index des Lichts in den Arrays des Fragment-Shaders (0 .. MAX_LICHTER - 1)
 */
open class PointLight(
    position: Vector3f,
    val lichtfarbe: Vector3f,
    private val slot: Int
) : Transformable(), IPointLight {

    // x = Kc, y = Kl, z = Kq (Tabelle 1)
    protected val abschwaechung: Vector3f = Vector3f(1.0f, 0.5f, 0.1f)

    protected open val typ: Int = TYP_PUNKT

    init {
        require(slot in 0 until MAX_LICHTER) { "kein Slot mehr frei: $slot" }
        translateGlobal(position)
    }

    override fun bind(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform(feld(name, "Type"), typ)
        shaderProgram.setUniform(feld(name, "Pos"), getWorldPosition())
        shaderProgram.setUniform(feld(name, "Col"), lichtfarbe)
        shaderProgram.setUniform(feld(name, "Att"), abschwaechung)
    }

    // z.B. "u_lightPos[3]"
    protected fun feld(name: String, art: String): String = name + art + "[" + slot + "]"

    companion object {
        const val MAX_LICHTER: Int = 8      // wie MAX_LIGHTS im Shader
        const val TYP_PUNKT: Int = 0
        const val TYP_SPOT: Int = 1
    }
}
