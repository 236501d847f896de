package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import org.joml.Math.clamp
import org.joml.Math.toRadians
import org.joml.Vector3f

/** Two joints and a camera at the end: the mouse turns the joints, the wheel moves the camera. */
class OrbitRig(target: Transformable) {
    private val turn = Transformable(parent = target)
    private val tilt = Transformable(parent = turn)
    val camera = TronCamera().also { it.parent = tilt }

    private var pitch = toRadians(-28.0f)
    private var distance = 4.5f
    private var lastX = 0.0
    private var lastY = 0.0
    private var moved = false

    init {
        tilt.translateLocal(Vector3f(0.0f, 0.5f, 0.0f))
        tilt.rotateLocal(pitch, 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, distance))
    }

    fun mouse(x: Double, y: Double) {
        if (moved) {
            turn.rotateLocal(0.0f, ((lastX - x) * SENSITIVITY).toFloat(), 0.0f)
            val next = clamp(toRadians(-80.0f), toRadians(-5.0f), pitch + ((lastY - y) * SENSITIVITY).toFloat())
            tilt.rotateLocal(next - pitch, 0.0f, 0.0f)
            pitch = next
        }
        lastX = x
        lastY = y
        moved = true
    }

    fun zoom(steps: Float) {
        val next = clamp(2.0f, 12.0f, distance - steps)
        camera.translateLocal(Vector3f(0.0f, 0.0f, next - distance))
        distance = next
    }

    private companion object {
        const val SENSITIVITY = 0.002
    }
}
