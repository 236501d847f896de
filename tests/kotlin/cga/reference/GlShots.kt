package cga.reference

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.ColorFormat
import cga.framework.Frame
import cga.framework.RenderTarget
import cga.framework.context.OffscreenContext
import cga.framework.image.FloatImage
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.file.Path
import kotlin.io.path.createTempFile
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** What OpenGL makes of a step: the picture, and the number of the triangle that each pixel shows, as [ReferencePicture.surface]. */
internal class GlShot(
    val picture: FloatImage,
    val surface: IntArray,
) {
    fun write(
        folder: Path,
        step: Step,
    ) {
        val bytes = ByteBuffer.allocate(4 * (picture.rgba.size + surface.size))
        bytes.asFloatBuffer().put(picture.rgba)
        bytes.position(4 * picture.rgba.size).asIntBuffer().put(surface)
        folder.resolve(step.name).writeBytes(bytes.array())
    }

    companion object {
        const val WIDTH = 480
        const val HEIGHT = 270

        /** The scene that all shots are of. */
        fun scene(step: Step) = ScriptedScene(WIDTH, HEIGHT, step).apply { advanceTo(5.3) }

        fun read(
            folder: Path,
            step: Step,
        ): GlShot {
            val pixels = WIDTH * HEIGHT
            val bytes = ByteBuffer.wrap(folder.resolve(step.name).readBytes())
            val rgba = FloatArray(4 * pixels).also { bytes.asFloatBuffer().get(it) }
            val surface = IntArray(pixels).also { bytes.position(16 * pixels).asIntBuffer().get(it) }
            return GlShot(FloatImage(WIDTH, HEIGHT, rgba), surface)
        }
    }
}

/** Takes a shot of every step into the folder that is the first argument. A process of its own, for its environment chooses the filters. */
fun main(args: Array<String>) {
    OffscreenContext.open().use {
        RenderTarget(GlShot.WIDTH, GlShot.HEIGHT, 0, ColorFormat.RGBA32F).use { target ->
            for (step in Step.entries) {
                val scene = GlShot.scene(step).scene
                target.bind()
                scene.render()
                val picture = target.readFloats()
                drawNumbers(scene.frame())
                val numbers = target.readFloats().rgba
                GlShot(picture, IntArray(numbers.size / 4) { numbers[4 * it].toInt() }).write(Path.of(args[0]), step)
                scene.cleanup()
            }
        }
    }
}

/** Position, texture coordinates, normal: eight floats a vertex. */
private val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))

/** Draws [frame] with the number of its triangle as the colour of each pixel. */
private fun drawNumbers(frame: Frame) {
    val fragment = createTempFile(suffix = ".frag")
    fragment.writeText("#version 330 core\nuniform int first;\nout vec4 color;\nvoid main() { color = vec4(first + gl_PrimitiveID); }\n")
    val program = ShaderProgram("shaders/scene.vert", "$fragment")
    glClearColor(ReferencePicture.NO_SURFACE.toFloat(), 0f, 0f, 0f)
    glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
    program.use()
    program.setUniform("projection", frame.projection, false)
    var first = 0
    for (draw in frame.draws) {
        program.setUniform("modelView", Matrix4f(frame.view.mul(draw.model, Matrix4d())), false)
        program.setUniform("first", first)
        Mesh(draw.vertices, draw.indices, attributes).apply { render() }.cleanup()
        first += draw.indices.size / 3
    }
    program.cleanup()
}
