package cga.measure.accuracy.hard

import cga.exercise.game.Orbit
import cga.exercise.game.Ride
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.WindowState
import org.joml.Matrix3d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.lwjgl.glfw.GLFW.GLFW_KEY_A
import org.lwjgl.glfw.GLFW.GLFW_KEY_W
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sin

/** What piles up with time. */
internal object TimeCases {
    fun measure(): List<HardCase> = listOf(driving(), orbiting()) + listOf(3, 5, 7).map(::color)

    /** 2.3 hours of circling: 4 units and 1.5 radians a second. */
    private fun driving(): HardCase {
        val turn = 1.5 * FRAME
        val ride = Ride()
        val naive = Matrix4f().scale(0.8f)
        repeat(FRAMES) {
            ride.update(CirclingLeft, FRAME)
            naive.rotateY(turn.toFloat()).translate(0f, 0f, -(4 * FRAME / 0.8).toFloat())
        }
        // Headings add up to 12,500 rad; a million sums of it, and then the matrix's rounding to floats.
        val bound = FRAMES * FRAMES * turn * DOUBLE_ROUNDING + 3 * Rounding.U
        return turned(
            "10⁶ frames of driving in a circle",
            "float matrix · turn",
            naive,
            "heading as a number",
            ride.place(Matrix4f()),
            FRAMES * turn,
            0.8,
            bound,
        )
    }

    private fun orbiting(): HardCase {
        val orbit = Orbit()
        val naive = Matrix4f()
        for (x in 0..FRAMES) {
            orbit.onMouseMove(x.toDouble(), true)
            if (x > 0) naive.rotateY(0.002f)
        }
        // The camera also looks down.
        val ours = orbit.place(true, Matrix4f()).translate(0f, 0f, -4f).rotateX(Math.toRadians(35.0).toFloat())
        // The angle stays below 2π: a million roundings of it. Two products of floats undo the rest.
        val bound = FRAMES * 2 * PI * DOUBLE_ROUNDING + 8 * Rounding.U
        return turned("10⁶ mouse events of orbiting", "float matrix · turn", naive, "angle as a number", ours, FRAMES * 0.002, 1.0, bound)
    }

    /** The largest error of an axis, as a share of its length. */
    private fun turned(
        name: String,
        naive: String,
        naiveMatrix: Matrix4f,
        ours: String,
        ourMatrix: Matrix4f,
        angle: Double,
        scale: Double,
        bound: Double,
    ): HardCase {
        val truth = Matrix3d().rotationY(angle).scale(scale)

        fun error(matrix: Matrix4f) =
            matrix.get3x3(Matrix3d()).let { found ->
                (0..2).maxOf { truth.getColumn(it, Vector3d()).distance(found.getColumn(it, Vector3d())) / scale }
            }
        return HardCase(
            name,
            naive,
            error(naiveMatrix),
            ours,
            error(ourMatrix),
            bound,
            ErrorUnit.SHARE,
            "each frame's rounding stays: the model shears and shrinks",
        )
    }

    /** The motorcycle's red, |sin t|, in a second of 60 frames from t = 10^[decade] on. */
    private fun color(decade: Int): HardCase {
        val t = 10.0.pow(decade)
        val scene = ScriptedScene(16, 9, Step.COLOR)
        var naiveError = 0.0
        var ourError = 0.0
        for (frame in 0 until 60) {
            val now = t + frame / 60.0
            val truth = abs(sin(now))
            scene.advanceTo(now)
            val ours = scene.scene.frame().draws.last().tint.x()
            ourError = maxOf(ourError, abs(ours - truth))
            naiveError = maxOf(naiveError, abs(abs(sin(now.toFloat())) - truth))
        }
        val failure = if (Math.ulp(t.toFloat()) > 2 / 255.0) "a float's step there is %s s".format(Math.ulp(t.toFloat())) else ""
        return HardCase(
            "colour at t = 1e$decade s",
            "t as a float",
            255 * naiveError,
            "t as a double",
            255 * ourError,
            255 * Rounding.U,
            ErrorUnit.COLOR,
            failure,
        )
    }

    private object CirclingLeft : WindowState {
        override val framebufferWidth = 1
        override val framebufferHeight = 1

        override fun getKeyState(key: Int): Boolean = key == GLFW_KEY_W || key == GLFW_KEY_A
    }

    private const val FRAMES = 1_000_000
    private const val FRAME = 1.0 / 120
    private const val DOUBLE_ROUNDING = 1.0 / (1L shl 53)
}
