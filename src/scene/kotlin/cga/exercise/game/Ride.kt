package cga.exercise.game

import cga.framework.WindowState
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.lwjgl.glfw.GLFW.*
import kotlin.math.cos
import kotlin.math.sin

/**
 * Driving on the ground plane: W forwards, S backwards, A and D steer while driving.
 *
 * Place and heading are kept as numbers in double precision and the matrix is made anew from them: a million small rotations
 * multiplied into a float matrix would shear the motorcycle visibly.
 */
public class Ride {
    /** World units. */
    public var x: Double = 0.0
        private set
    public var z: Double = 0.0
        private set

    /** Radians about y, counter-clockwise from above; 0 looks along −z. */
    public var heading: Double = 0.0
        private set

    private val matrix = Matrix4d()

    /** Drives for [dt] seconds with the keys that [window] reports. */
    public fun update(
        window: WindowState,
        dt: Double,
    ) {
        val gear = window.axis(GLFW_KEY_W, GLFW_KEY_S)
        val steering = window.axis(GLFW_KEY_A, GLFW_KEY_D)
        heading += gear * steering * TURN_SPEED * dt
        x -= sin(heading) * gear * SPEED * dt
        z -= cos(heading) * gear * SPEED * dt
    }

    /** The motorcycle's model matrix, into [dest]. */
    public fun place(dest: Matrix4f): Matrix4f =
        dest.set(
            matrix
                .translation(x, 0.0, z)
                .rotateY(heading)
                .scale(SCALE),
        )

    private fun WindowState.axis(
        positive: Int,
        negative: Int,
    ): Int = (if (getKeyState(positive)) 1 else 0) - (if (getKeyState(negative)) 1 else 0)

    private companion object {
        const val SPEED = 4.0
        const val TURN_SPEED = 1.5
        const val SCALE = 0.8
    }
}
