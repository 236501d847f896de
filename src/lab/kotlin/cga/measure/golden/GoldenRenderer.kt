package cga.measure.golden

import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import cga.imaging.golden.Machine
import cga.imaging.golden.Origin
import cga.imaging.golden.Rendered
import org.lwjgl.opengl.GL33C.*

/** Makes the pictures of golden cases, each in an OpenGL context of its own, so that none can leave anything behind for the next. */
public class GoldenRenderer(private val context: ContextKind? = null) {
    /** The picture of [case] as this code, these shaders and this machine draw it. Throws [cga.framework.InputError] where it cannot. */
    public fun render(case: GoldenCase): Rendered {
        val player = case.scene()
        val inputs = InputHash.ofFiles() + SceneHash.of(player.scene.frame())
        OffscreenContext.open(context).use {
            val machine = Machine.of(glGetString(GL_RENDERER).orEmpty(), glGetString(GL_VERSION).orEmpty())
            val format = if (case.float) ColorFormat.RGBA32F else ColorFormat.RGBA8
            RenderTarget(GoldenCase.WIDTH, GoldenCase.HEIGHT, case.samples, format).use { target ->
                target.bind()
                player.scene.render()
                return Rendered(read(target, case), Origin(machine, case.made(), inputs)).also { player.scene.cleanup() }
            }
        }
    }

    private fun read(
        target: RenderTarget,
        case: GoldenCase,
    ): Picture = if (case.float) FloatPicture.opaque(target.readFloats()) else BytePicture.opaque(target.read())
}
