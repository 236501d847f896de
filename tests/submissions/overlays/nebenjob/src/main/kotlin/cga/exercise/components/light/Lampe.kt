package cga.exercise.components.light

import cga.exercise.components.shader.ShaderProgram
import org.joml.Vector3f

// 4.6: steht fest in der gegend rum, k ist wie beim ersten licht (kpl)
class Lampe(private val nr: Int, x: Float, z: Float, private val farbe: Vector3f) {
    private val wo = Vector3f(x, 1.3f, z)

    fun an(s: ShaderProgram) {
        s.setUniform("posl$nr", wo)
        s.setUniform("coll$nr", farbe)
    }
}
