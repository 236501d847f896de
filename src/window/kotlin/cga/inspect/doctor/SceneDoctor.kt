package cga.inspect.doctor

import cga.exercise.game.DriveScript
import cga.exercise.game.NewProgram
import cga.exercise.game.Scene
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.inspect.view.InspectedProgram
import cga.inspect.view.Look
import cga.inspect.view.Traffic

/**
 * What the doctor says of a scene.
 *
 * @param isBlack whether the picture is; [isUnlit] whether the lights make no difference to it.
 * @param findings the likely causes, the likeliest first.
 */
public class SceneReport internal constructor(
    public val isBlack: Boolean,
    public val isUnlit: Boolean,
    public val findings: List<Pair<String, String>>,
)

/** Examines the scene off screen: what the window's overlay does when its picture is dark. */
public object SceneDoctor {
    /**
     * Draws [step] at [time] (seconds) in a context of [kind], or of the first kind that works, and looks for causes of a dark picture.
     * Throws [cga.framework.InputError] where the scene cannot be read, its shaders not compiled, or no context made.
     */
    public fun examine(
        step: Step,
        time: Double,
        kind: ContextKind? = null,
    ): SceneReport {
        val look = Look()
        val traffic = Traffic()
        return examine(step, time, kind, look, traffic) { vertex, fragment, constants ->
            InspectedProgram(vertex, fragment, constants, look, traffic)
        }
    }

    /** The same with other programs, and after [change] has been made to the scene. */
    internal fun examine(
        step: Step,
        time: Double,
        kind: ContextKind?,
        look: Look,
        traffic: Traffic,
        change: (Scene) -> Unit = {},
        newProgram: NewProgram,
    ): SceneReport {
        val player = ScriptedScene(WIDTH, HEIGHT, step, DriveScript.NONE, newProgram)
        player.advanceTo(time)
        change(player.scene)
        return OffscreenContext.open(kind).use {
            try {
                val evidence = EvidenceReader(player.scene, look, traffic).read()
                SceneReport(evidence.isBlack, evidence.isUnlit, Diagnosis.of(evidence).map { it.found to it.cure })
            } finally {
                player.scene.cleanup()
            }
        }
    }

    private const val WIDTH = 1280
    private const val HEIGHT = 720
}
