package cga.inspect

import cga.exercise.game.Scene
import cga.framework.SpecularModel
import cga.inspect.light.Gizmos
import cga.inspect.tune.Tuning
import cga.inspect.view.Look
import org.lwjgl.opengl.GL33C.*

/**
 * The scene as it is looked at and tuned: all that the window's picture is made of besides the panels, and that a recording plays again.
 *
 * @param scene whose programs obey [look].
 */
internal class InspectedScene(
    val scene: Scene,
    val look: Look,
    val tuning: Tuning,
) : AutoCloseable {
    private var gizmos: Gizmos? = null

    /** Draws it into the framebuffer that is bound, of [width]×[height] pixels: twice where Phong and Blinn-Phong stand side by side. */
    fun draw(
        width: Int,
        height: Int,
    ) {
        if (!look.isSplit) return scene.render()
        val divider = divider(width)
        glEnable(GL_SCISSOR_TEST)
        draw(SpecularModel.PHONG, 0, divider, height)
        draw(SpecularModel.BLINN_PHONG, divider, width, height)
        glDisable(GL_SCISSOR_TEST)
    }

    private fun draw(
        model: SpecularModel,
        left: Int,
        right: Int,
        height: Int,
    ) {
        glScissor(left, 0, right - left, height)
        look.specularModel = model
        scene.render()
        look.specularModel = null
    }

    /** Whose highlight the picture has in [column] of a picture of [width]. */
    fun modelAt(
        column: Int,
        width: Int,
    ): SpecularModel =
        when {
            !look.isSplit -> scene.specularModel
            column < divider(width) -> SpecularModel.PHONG
            else -> SpecularModel.BLINN_PHONG
        }

    private fun divider(width: Int) = (look.divider * width).toInt()

    /** The lights' markers, where they are wanted, over what [draw] has drawn. */
    fun drawGizmos() {
        if (look.hasGizmos) (gizmos ?: Gizmos(scene.camera).also { gizmos = it }).draw(tuning.inspected)
    }

    /** To be called when the scene has another step. */
    fun stepChanged() {
        tuning.stepChanged()
        look.light = 0
    }

    /** Frees what the markers hold on the GPU; the scene is its owner's. */
    override fun close() {
        gizmos?.close()
    }
}
