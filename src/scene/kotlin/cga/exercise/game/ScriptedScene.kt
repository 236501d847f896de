package cga.exercise.game

import cga.exercise.components.shader.ShaderProgram
import cga.framework.WindowState
import kotlin.math.roundToLong

/**
 * The scene without a window: keys come from a [DriveScript], time and mouse from the caller, so that the same arguments always give
 * the same picture.
 *
 * @param width of the picture in pixels, likewise [height].
 */
public class ScriptedScene(
    width: Int,
    height: Int,
    step: Step,
    private val drive: DriveScript,
    newProgram: NewProgram,
) : WindowState {
    public constructor(
        width: Int,
        height: Int,
        step: Step = Step.FINAL,
        drive: DriveScript = DriveScript.NONE,
    ) : this(width, height, step, drive, ::ShaderProgram)

    override val framebufferWidth: Int = width
    override val framebufferHeight: Int = height
    private var updates = 0L

    /** The scene itself, for its settings. */
    public val scene: Scene = Scene(this, step, newProgram)

    init {
        scene.onMouseMove(0.0, 0.0)
    }

    override fun getKeyState(key: Int): Boolean = drive.isDown(key, (updates + 0.5) * UPDATE_STEP)

    /** Brings the scene to time [t] (seconds, not before the last one) as a window would, by updates 1/120 s apart. */
    public fun advanceTo(t: Double) {
        // When the script has ended nothing drives any more, and the updates until t can be left out.
        val due = (minOf(t, drive.duration) / UPDATE_STEP).roundToLong()
        while (updates < due) {
            scene.update(UPDATE_STEP, updates * UPDATE_STEP)
            updates++
        }
        scene.update(0.0, t)
    }

    /** Puts the mouse [pixels] to the right of where it started. */
    public fun moveMouseTo(pixels: Double) {
        scene.onMouseMove(pixels, 0.0)
    }

    public companion object {
        /** A time, in seconds, at which the motorcycle has a saturated colour; at 0 it is black. */
        public const val PRETTY_TIME: Double = 5.3
        private const val UPDATE_STEP = 1.0 / 120
    }
}
