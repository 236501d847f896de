package cga.measure.accuracy

import cga.exercise.components.light.PointLight
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.Frame
import cga.framework.FrameDraw
import cga.framework.FrameMaterial
import cga.framework.FrameTexture
import org.lwjgl.opengl.GL33C.GL_LINEAR

/** What is drawn of a step to be compared; the size in pixels. */
internal enum class TruthView(
    val width: Int,
    val height: Int,
) {
    /** The scene as it is. */
    SCENE(480, 270),

    /** The scene with textures that have no mip levels, so that no λ is to be chosen: all that remains is the lighting. */
    FIRST_LEVEL(240, 135),
    ;

    fun scene(step: Step): ScriptedScene =
        ScriptedScene(width, height, step).apply {
            moveMouseTo(MOUSE)
            advanceTo(TIME)
        }

    fun frame(step: Step): Frame {
        val frame = scene(step).scene.frame()
        return if (this == SCENE) {
            frame
        } else {
            frame.run {
                Frame(view, projection, ambient, specularModel, gamma, lights, draws.map(::withoutLevels))
            }
        }
    }

    /** The lights of [frame], as the scene has them. */
    fun lights(step: Step): List<PointLight> = scene(step).scene.apply { frame() }.lights.shining

    private companion object {
        /** A moment at which no colour of the motorcycle is dark. */
        const val TIME = 5.3

        /** Pixels to the right: where a step turns with the mouse, the motorcycle is seen from the side. */
        const val MOUSE = 400.0

        fun withoutLevels(draw: FrameDraw) =
            draw.material.run {
                val material =
                    FrameMaterial(withoutLevels(emissive), withoutLevels(diffuse), withoutLevels(specular), shininess, tcMultiplier)
                FrameDraw(draw.vertices, draw.indices, draw.model, draw.tint, material)
            }

        fun withoutLevels(texture: FrameTexture) = texture.run { FrameTexture(image, wrapS, wrapT, GL_LINEAR, magFilter) }
    }
}
