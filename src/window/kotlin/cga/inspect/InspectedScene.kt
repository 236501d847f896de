package cga.inspect

import cga.exercise.game.Scene
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.SpecularModel
import cga.framework.image.FloatImage
import cga.inspect.light.Gizmos
import cga.inspect.tune.Tuning
import cga.inspect.view.Look
import org.joml.Vector2f
import org.joml.Vector2fc
import org.lwjgl.opengl.GL33C.*
import kotlin.math.abs

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
    private val place = Vector2f()

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

    /** Whether Phong and Blinn-Phong draw the same picture now. */
    fun areSidesEqual(): Boolean {
        val (phong, blinnPhong) = SpecularModel.entries.map(::small)
        return phong.rgba.indices.all { abs(phong.rgba[it] - blinnPhong.rgba[it]) < VISIBLE }
    }

    private fun small(model: SpecularModel): FloatImage =
        RenderTarget(SMALL_WIDTH, SMALL_HEIGHT, 0, ColorFormat.RGBA32F)
            .use { target ->
                target.bind()
                look.specularModel = model
                scene.render()
                look.specularModel = null
                target.readFloats()
            }.also { glBindFramebuffer(GL_FRAMEBUFFER, 0) }

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

    /** Has [draw] write the name of each light that is marked at its place, in shares of the picture's width and height. */
    fun nameGizmos(draw: (name: String, place: Vector2fc) -> Unit) {
        val gizmos = gizmos ?: return
        for (light in tuning.lights) if (gizmos.place(light.inspected, place)) draw(light.name, place)
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

    private companion object {
        const val SMALL_WIDTH = 320
        const val SMALL_HEIGHT = 180

        /** One step of 255. */
        const val VISIBLE = 1f / 255
    }
}
