package cga.exercise.components.geometry

import org.joml.Matrix4f
import org.joml.Vector3f

/** Die Matrizen von der Tafel (Tutorium zu Blatt 4), damit nicht überall das Gleiche steht. */
object Matrices {

    /** V. Die Kamera hängt am Motorrad und erbt dessen Skalierung, die darf in V nicht drin sein. */
    fun view(kameraWelt: Matrix4f): Matrix4f {
        val K = Matrix4f(kameraWelt)
        K.normalize3x3()
        return K.invert()
    }

    /** MV = V * M */
    fun modelView(V: Matrix4f, M: Matrix4f): Matrix4f {
        return Matrix4f(V).mul(M)
    }

    /** N = (MV^-1)^T */
    fun normalMatrix(MV: Matrix4f): Matrix4f {
        return Matrix4f(MV).invert().transpose()
    }

    /** Richtung von Welt nach View (ohne Translation) */
    fun richtungInView(V: Matrix4f, richtung: Vector3f): Vector3f {
        return V.transformDirection(richtung, Vector3f())
    }

    /** T(punkt) * R * T(-punkt) */
    fun rotationUm(punkt: Vector3f, pitch: Float, yaw: Float, roll: Float): Matrix4f {
        val hin = Matrix4f().translation(-punkt.x, -punkt.y, -punkt.z)
        val dreh = Matrix4f().rotationXYZ(pitch, yaw, roll)
        val zurueck = Matrix4f().translation(punkt)
        return zurueck.mul(dreh).mul(hin)
    }
}
