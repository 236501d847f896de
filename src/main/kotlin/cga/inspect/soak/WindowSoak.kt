package cga.inspect.soak

import cga.exercise.game.Step
import cga.inspect.InspectedGame
import org.lwjgl.glfw.GLFW.*
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readLines

/** What was held at a moment of a soak. */
public class Held(
    public val seconds: Double,
    public val pictures: Int,
    public val mebibytes: Double,
    public val glObjects: Int,
)

/**
 * The window, used without a pause: steps, views, panel, gizmos, split view, reloads, driving, each in turn, and every so often a look at what it
 * holds. The keys are pressed from inside, so that nothing else is needed than a display.
 *
 * @param seconds how long.
 * @param every between two looks.
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
    private var key = 0

    override fun getKeyState(key: Int): Boolean = key == GLFW_KEY_W || (key == GLFW_KEY_A && pictures % 200 < 100)

    override fun render(
        dt: Float,
        t: Float,
    ) {
        super.render(dt, t)
        pictures++
        if (pictures % PICTURES_PER_KEY == 0) press(KEYS[key++ % KEYS.size])
        if (currentTime < next) return
        next = currentTime + every
        val held = Held(currentTime, pictures, mebibytes(), GlObjects.count())
        looks += held
        report(held)
        if (currentTime >= seconds) quit()
    }

    private fun press(key: Int) {
        for (action in listOf(GLFW_PRESS, GLFW_RELEASE)) onKey(key, 0, action, 0)
        onMouseMove(Math.floorMod(pictures * 7, width).toDouble(), height / 3.0)
        for (action in listOf(GLFW_PRESS, GLFW_RELEASE)) onMouseButton(GLFW_MOUSE_BUTTON_LEFT, action, 0)
    }

    // The operating system's own figure, where it has one; else the heap's.
    private fun mebibytes(): Double {
        val status = Path.of("/proc/self/status")
        val line = if (status.exists()) status.readLines().find { it.startsWith("VmRSS:") } else null
        val kibibytes = line?.filter(Char::isDigit)?.toDouble()
        return kibibytes?.div(KIB) ?: Runtime.getRuntime().run { (totalMemory() - freeMemory()) / (KIB * KIB) }
    }

    private companion object {
        const val PICTURES_PER_KEY = 10
        const val KIB = 1024.0
        val KEYS: List<Int> =
            (GLFW_KEY_1..GLFW_KEY_8) +
                listOf(GLFW_KEY_TAB, GLFW_KEY_V, GLFW_KEY_B, GLFW_KEY_G, GLFW_KEY_F, GLFW_KEY_R) +
                listOf(GLFW_KEY_P, GLFW_KEY_V, GLFW_KEY_P, GLFW_KEY_C)
    }
}

/** Whether what was held stays the same: told from the second half of [looks], when everything has been used once. */
public object Flatness {
    /** So much resident memory may differ between the quarters: the heap breathes. */
    public const val MEBIBYTES: Double = 32.0

    private fun median(
        looks: List<Held>,
        of: (Held) -> Double,
    ): Double = looks.map(of).sorted()[looks.size / 2]

    /** What grew, in words; null where nothing did. */
    public fun growth(looks: List<Held>): String? {
        val second = looks.drop(looks.size / 2)
        if (second.size < 2) return "too few looks to tell: soak longer"
        val (third, fourth) = second.chunked((second.size + 1) / 2).let { it.first() to it.last() }
        val memory = median(fourth) { it.mebibytes } - median(third) { it.mebibytes }
        val objects = median(fourth) { it.glObjects.toDouble() } - median(third) { it.glObjects.toDouble() }
        return when {
            objects > 0 -> "the OpenGL objects grew by %.0f from the third quarter to the fourth".format(objects)
            memory > MEBIBYTES -> "the resident memory grew by %.0f MiB from the third quarter to the fourth".format(memory)
            else -> null
        }
    }
}
