package cga.measure.twin

import cga.exercise.game.DriveScript
import cga.exercise.game.Scene
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.Frame
import cga.framework.RenderTarget
import cga.framework.image.ImageData

/**
 * A frame as our renderer draws it: everything that it sends to OpenGL, and the picture that comes of it.
 *
 * @param frame what is drawn, and with which textures.
 * @param constants of the program that draws it.
 * @param uniforms in the order in which they are sent.
 * @param parameters what the scene's matrices are made of, by name: for the twin that computes its own.
 */
internal class RecordedFrame(
    val frame: Frame,
    val constants: Map<String, Int>,
    val uniforms: List<SentUniform>,
    val parameters: Map<String, Double>,
    val picture: ImageData,
    val samples: Int,
) {
    companion object {
        /** Draws [shot] in the current context, whose state it changes. */
        fun of(shot: TwinShot): RecordedFrame {
            val programs = ArrayList<UniformRecorder>()
            val player =
                ScriptedScene(shot.width, shot.height, shot.step, shot.drive) { vertex, fragment, constants ->
                    UniformRecorder(vertex, fragment, constants).also { programs += it }
                }
            player.moveMouseTo(shot.mouse)
            player.advanceTo(shot.time)
            programs.forEach { it.isRecording = true }
            return RenderTarget(shot.width, shot.height, shot.samples).use { target ->
                target.bind()
                player.scene.render()
                val used = programs.single { it.sent.isNotEmpty() }
                val picture = target.read()
                val recorded =
                    RecordedFrame(player.scene.frame(), used.constants, used.sent, parameters(player.scene), picture, shot.samples)
                player.scene.cleanup()
                recorded
            }
        }

        private fun parameters(scene: Scene): Map<String, Double> =
            mapOf(
                "x" to scene.ride.x,
                "z" to scene.ride.z,
                "heading" to scene.ride.heading,
                "orbit" to if (scene.step.turnsWithMouse) scene.orbit.angle else 0.0,
                "fieldOfView" to scene.camera.fieldOfView.toDouble(),
                "aspect" to scene.camera.aspect.toDouble(),
                "near" to scene.camera.near.toDouble(),
                "far" to scene.camera.far.toDouble(),
            )
    }
}

/** Which picture: as the options of `cga render` say it. */
internal data class TwinShot(
    val step: Step = Step.FINAL,
    val width: Int = 1280,
    val height: Int = 720,
    val samples: Int = 0,
    val time: Double = ScriptedScene.PRETTY_TIME,
    val mouse: Double = 0.0,
    val drive: DriveScript = DriveScript.NONE,
)
