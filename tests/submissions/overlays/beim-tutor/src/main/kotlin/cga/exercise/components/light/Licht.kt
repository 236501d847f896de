package cga.exercise.components.light

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

/**
 * Was alle Lichter gemeinsam haben.
 *
 * Namen im Shader: pos_..., L_... und K_..., dahinter der Name vom Licht
 */
abstract class Licht(position: Vector3f, var farbe: Vector3f) : Transformable() {

    /** (K_c, K_l, K_q) */
    abstract val K: Vector3f

    init {
        translateGlobal(position)
    }

    protected fun bindGrundwerte(shaderProgram: ShaderProgram, name: String) {
        shaderProgram.setUniform("pos_$name", getWorldPosition())
        shaderProgram.setUniform("L_$name", farbe)
        shaderProgram.setUniform("K_$name", K)
    }
}
