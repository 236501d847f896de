package cga.inspect

import cga.exercise.game.DriveScript
import cga.exercise.game.Scene
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.FloatImage
import cga.inspect.view.InspectedProgram
import cga.inspect.view.Look
import cga.inspect.view.Traffic

/** The scene as the inspector looks at it, off screen: 160×90 pixels at a time when the motorcycle has a colour. */
internal class Inspected(step: Step = Step.FINAL) {
    val look = Look()
    val traffic = Traffic()
    val scene: Scene =
        ScriptedScene(WIDTH, HEIGHT, step, DriveScript.NONE) { v, f, constants -> InspectedProgram(v, f, constants, look, traffic) }
            .apply { advanceTo(ScriptedScene.PRETTY_TIME) }
            .scene

    /** What it draws, unclamped. */
    fun draw(): FloatImage =
        RenderTarget(WIDTH, HEIGHT, 0, ColorFormat.RGBA32F).use { target ->
            target.bind()
            scene.render()
            target.readFloats()
        }

    companion object {
        const val WIDTH = 160
        const val HEIGHT = 90
    }
}
