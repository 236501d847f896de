package cga.grading.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import kotlin.math.PI
import kotlin.math.max
import kotlin.math.min

/** Does the mouse's way to the side turn the camera about the vertical, and does the horizon stay level? */
internal class OrbitAxis(private val book: Notebook) {
    /** Judges all that turned, and of these what the mouse did by going to the side; answers whether the camera's circle is tilted. */
    fun judge(
        turning: List<Turn>,
        sideways: List<Turn>,
    ): Boolean {
        val lying = sideways.filter { it.lies() }
        if (lying.isNotEmpty()) {
            lying(lying.maxBy { it.tilt })
        } else if (isLevel(turning, sideways)) {
            return isTilted(sideways)
        }
        return false
    }

    /** About an axis that is nearer to level than to anything upright: the way to the side does what that up and down should do. */
    private fun lying(turn: Turn) {
        val angle = Math.toDegrees(turn.tilt).text()
        val text = "Moving the mouse to the side turns the camera about an axis $angle° from the vertical; wanted: 0°."
        book.measured(Check.ORBIT, turn.tilt / (PI / 2), text)
        book.measured(Check.ORBIT_HORIZON, 0.0, "The camera turns about an axis that lies: that costs at the orbit.")
        book.found(Mistake.UNKNOWN, 1.0, turn.tilt / (PI / 2), "camera, when the mouse moves to the side")
    }

    private fun Turn.lies() = min(tilt, fromOwnAxis) > PI / 4

    private fun isLevel(
        turning: List<Turn>,
        sideways: List<Turn>,
    ): Boolean {
        val error = turning.maxOf { it.rolled() }
        book.measured(Check.ORBIT_HORIZON, error, "The horizon tilts by ${error.percent()} of the angle turned; wanted 0 %.")
        if (error <= NAMED) return true
        val rolled = sideways.maxBy { it.rolled() }
        if (rolled.rolled() > NAMED) {
            book.found(Mistake.ORBIT_OWN_AXIS, rolled.fromOwnAxis / rolled.tilt, rolled.rolled(), "camera")
        } else {
            book.found(Mistake.ORBIT_OWN_AXIS, error, error, "camera, when the mouse moves up or down")
        }
        return false
    }

    /** A camera that keeps looking at the motorcycle has a level horizon, whatever it circles about. */
    private fun isTilted(sideways: List<Turn>): Boolean {
        val error = sideways.maxOf { it.rise / max(it.angle, LEAST_TURN) }
        if (error <= NAMED) return false
        book.measured(Check.ORBIT, error, "The camera rises or sinks when the mouse moves to the side; wanted: it keeps its height.")
        book.found(Mistake.UNKNOWN, 1.0, error, "camera, when the mouse moves to the side")
        return true
    }

    private fun Turn.rolled() = roll / max(angle, LEAST_TURN)

    private companion object {
        /** Radians. */
        const val LEAST_TURN = 1e-2

        /** Relative. */
        const val NAMED = 0.02
    }
}
