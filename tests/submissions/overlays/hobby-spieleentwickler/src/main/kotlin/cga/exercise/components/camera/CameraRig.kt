package cga.exercise.components.camera

import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.childOf
import org.joml.Vector3f

/**
 * target -> pivot (yaw) -> camera on a boom, looking down at the target.
 */
class CameraRig(target: Transformable, distance: Float, tilt: Float) {
    val pivot = Transformable() childOf target
    val camera = TronCamera() childOf pivot

    init {
        camera.rotateLocal(-tilt, 0.0f, 0.0f)
        camera.translateLocal(Vector3f(0.0f, 0.0f, distance))
    }

    fun yaw(angle: Float) = pivot.rotateLocal(0.0f, angle, 0.0f)
}
