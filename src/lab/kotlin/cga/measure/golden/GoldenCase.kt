package cga.measure.golden

import cga.exercise.game.DriveScript
import cga.exercise.game.ScriptedScene
import cga.exercise.game.ScriptedScene.Companion.PRETTY_TIME
import cga.exercise.game.Step
import cga.framework.SpecularModel

/**
 * One picture of the scene that a golden image is kept of.
 *
 * @param name short, unique, and the name of the files.
 * @param shows what this picture tests that the others do not, in a few words.
 * @param t seconds.
 * @param mouse pixels to the right, over all.
 * @param drive a [DriveScript], which has ended at [t]; empty for none.
 * @param specular null for the step's own.
 * @param float whether the picture is unclamped and in floats.
 */
public class GoldenCase(
    public val name: String,
    public val shows: String,
    public val step: Step,
    public val t: Double = PRETTY_TIME,
    public val mouse: Double = 0.0,
    public val drive: String = "",
    public val samples: Int = 0,
    public val specular: SpecularModel? = null,
    public val gamma: Float = 1f,
    public val float: Boolean = false,
) {
    /** The scene as this picture shows it; made without an OpenGL context. */
    public fun scene(): ScriptedScene {
        val script = if (drive.isEmpty()) DriveScript.NONE else DriveScript.parse(drive)
        require(script.duration <= t) { "case $name: its drive takes ${script.duration} s, and its picture is of t = $t" }
        return ScriptedScene(WIDTH, HEIGHT, step, script).also {
            specular?.let { model -> it.scene.specularModel = model }
            it.scene.gamma = gamma
            it.moveMouseTo(mouse)
            it.advanceTo(t)
        }
    }

    /** All of that by name, as it goes into the sidecar. */
    internal fun made(): Map<String, String> =
        linkedMapOf(
            "size" to "${WIDTH}x$HEIGHT",
            "step" to step.sheet,
            "t" to "$t",
            "mouse" to "$mouse",
            "drive" to drive,
            "samples" to "$samples",
            "specular" to (specular ?: step.specularModel).title,
            "gamma" to "$gamma",
            "format" to if (float) "RGBA32F" else "RGBA8",
        )

    override fun toString(): String = name

    public companion object {
        public const val WIDTH: Int = 480
        public const val HEIGHT: Int = 270
    }
}
