package cga.cli

import cga.exercise.game.Scene
import org.joml.Matrix4f

/**
 * Where the camera of a picture is: turned about a point of the motorcycle.
 *
 * @param word its name on the command line.
 * @param yaw degrees about the vertical; 0 is behind the motorcycle, 90 on its right.
 * @param pitch degrees; negative looks down.
 * @param distance from the point, in the motorcycle's space.
 * @param height of the point above the ground, [ahead] its distance in front of the motorcycle's middle.
 */
internal enum class CameraView(
    val word: String,
    private val yaw: Float,
    private val pitch: Float,
    private val distance: Float,
    private val height: Float,
    private val ahead: Float,
) {
    FRONT("front", yaw = 128f, pitch = -15f, distance = 4.1f, height = 0.35f, ahead = 0.5f),
    REAR("rear", yaw = 50f, pitch = -15f, distance = 4.4f, height = 0.35f, ahead = 0.45f),
    SIDE("side", yaw = 78f, pitch = -11f, distance = 4.2f, height = 0.4f, ahead = 0.5f),
    ;

    /** Puts the camera of [scene] there, with a lens that is longer than the course's. */
    fun place(scene: Scene) {
        scene.cameraPlace =
            Matrix4f()
                .translation(0f, height, -ahead)
                .rotateY(radians(yaw))
                .rotateX(radians(pitch))
                .translate(0f, 0f, distance)
        scene.camera.fieldOfView = radians(FIELD_OF_VIEW)
    }

    private companion object {
        const val FIELD_OF_VIEW = 42f

        fun radians(degrees: Float): Float = Math.toRadians(degrees.toDouble()).toFloat()
    }
}
