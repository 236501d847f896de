package cga.exercise.game

class MouseTracker {

    private var lastX: Double = 0.0
    private var started: Boolean = false

    /** How far the mouse went in x since the last call; nothing at the first. */
    fun moveTo(x: Double): Double {
        val difference: Double
        if (this.started) {
            difference = x - this.lastX
        } else {
            difference = 0.0
            this.started = true
        }
        this.lastX = x
        return difference
    }
}
