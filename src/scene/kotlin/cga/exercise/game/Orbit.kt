package cga.exercise.game

import org.joml.Matrix4d
import org.joml.Matrix4f

/**
 * The camera's place behind and above the motorcycle, turned about it by the mouse.
 *
 * The angle is kept as a number in double precision and the matrix made anew from it, so that the distance never changes and the
 * horizon never tilts, however long the mouse moves.
 */
public class Orbit {
    /** Radians about y, in (−2π, 2π). */
    public var angle: Double = 0.0
        private set
    private val matrix = Matrix4d()
    private var lastX = Double.NaN

    /** The mouse is at [xpos] (pixels). The first position only says where it starts; [turning] = false moves it without effect. */
    public fun onMouseMove(
        xpos: Double,
        turning: Boolean,
    ) {
        // solution 4.5: turn by 0.002 rad for each pixel since the last call; the very first call turns nothing
        if (!xpos.isFinite()) return
        if (turning && !lastX.isNaN()) angle = (angle + RADIANS_PER_PIXEL * (xpos - lastX)) % (2 * Math.PI)
        lastX = xpos
        // end of solution
    }

    /** The camera's matrix in the motorcycle's space, into [dest]. */
    public fun place(
        turned: Boolean,
        dest: Matrix4f,
    ): Matrix4f =
        dest.set(
            matrix
                // solution 4.5: turn about the motorcycle, when turned
                // instead: .identity()
                .rotationY(if (turned) angle else 0.0)
                // end of solution
                .rotateX(PITCH)
                .translate(0.0, 0.0, DISTANCE),
        )

    private companion object {
        const val RADIANS_PER_PIXEL = 0.002
        const val DISTANCE = 4.0
        val PITCH = Math.toRadians(-35.0)
    }
}
