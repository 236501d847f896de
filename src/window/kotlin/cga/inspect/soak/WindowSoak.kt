package cga.inspect.soak

import cga.exercise.game.Step
import cga.inspect.InspectedGame
import cga.inspect.view.View
import org.lwjgl.glfw.GLFW.*

/**
 * The window, used without a pause: steps, views, panel, gizmos, split view, reloads, driving, each in turn, and every so often a look at
 * what it holds. It begins with a warm-up, in which every step is seen in every view once. The keys are pressed from inside, so that
 * nothing else is needed than a display.
 *
 * @param seconds how long, after the warm-up.
 * @param every seconds between two looks.
 */
public class WindowSoak(
    width: Int,
    height: Int,
    private val seconds: Double,
    private val every: Double,
    private val report: (Held) -> Unit,
) : InspectedGame(width, height, false, 0, Step.FINAL) {
    /** What was found, in order. */
    public val looks: MutableList<Held> = ArrayList()
    private var pictures = 0
    private var next = 0.0
    private var begin = 0.0
    private var key = 0

    override fun getKeyState(key: Int): Boolean = key == GLFW_KEY_W || (key == GLFW_KEY_A && pictures % 200 < 100)

    override fun render(
        dt: Float,
        t: Float,
    ) {
        super.render(dt, t)
        pictures++
        if (key < WARM_UP.size) {
            press(WARM_UP[key++])
            begin = currentTime
            return
        }
        if (pictures % PICTURES_PER_KEY == 0) press(KEYS[key++ % KEYS.size])
        if (currentTime - begin >= next) look()
    }

    private fun look() {
        val time = currentTime - begin
        next = time + every
        val held = Held.now(time, pictures)
        looks += held
        report(held)
        if (time >= seconds) quit()
    }

    private fun press(key: Int) {
        for (action in listOf(GLFW_PRESS, GLFW_RELEASE)) onKey(key, 0, action, 0)
        onMouseMove(Math.floorMod(pictures * 7, width).toDouble(), height / 3.0)
        for (action in listOf(GLFW_PRESS, GLFW_RELEASE)) onMouseButton(GLFW_MOUSE_BUTTON_LEFT, action, 0)
    }

    private companion object {
        const val PICTURES_PER_KEY = 10
        val KEYS: List<Int> =
            (GLFW_KEY_1..GLFW_KEY_8) +
                listOf(GLFW_KEY_TAB, GLFW_KEY_V, GLFW_KEY_B, GLFW_KEY_G, GLFW_KEY_F, GLFW_KEY_R) +
                listOf(GLFW_KEY_P, GLFW_KEY_V, GLFW_KEY_P, GLFW_KEY_C)

        /** Each step in each view, and twice everything else, which leaves it as it was. */
        val WARM_UP: List<Int> = (GLFW_KEY_1..GLFW_KEY_8).flatMap { step -> listOf(step) + View.entries.map { GLFW_KEY_V } } + KEYS + KEYS
    }
}
