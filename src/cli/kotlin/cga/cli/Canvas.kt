package cga.cli

import cga.exercise.game.Scene
import cga.framework.ColorFormat
import cga.framework.InputError
import cga.framework.RenderTarget
import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.framework.image.FloatImage
import cga.framework.image.ImageData
import cga.reference.ReferencePicture
import cga.reference.ReferenceRenderer

/** What makes pictures of the scene: OpenGL in a context of some [kind] (null: the first that works), or the reference, on the CPU. */
public sealed interface Renderer {
    public data class OpenGL(public val kind: ContextKind?) : Renderer

    public data object Reference : Renderer
}

/** Where a picture is drawn and read back from. */
public interface Canvas : AutoCloseable {
    /** Draws the scene as it is now. */
    public fun draw(scene: Scene)

    /** The last picture as a screen shows it. */
    public fun read(): ImageData

    /** The last picture, unclamped. */
    public fun readFloats(): FloatImage
}

/** A framebuffer in an OpenGL context of its own. Throws [cga.framework.InputError] where there is none of that kind or size. */
public class OpenGLCanvas(
    kind: ContextKind?,
    size: Size,
    samples: Int,
    format: ColorFormat,
) : Canvas {
    private val context = OffscreenContext.open(kind)
    private val target =
        try {
            RenderTarget(size.width, size.height, samples, format)
        } catch (e: Throwable) {
            context.close()
            throw e
        }

    override fun draw(scene: Scene): Unit = draw(scene::render)

    /** Draws by whatever [paint] draws with. */
    public fun draw(paint: () -> Unit) {
        target.bind()
        paint()
    }

    override fun read(): ImageData = target.read()

    override fun readFloats(): FloatImage = target.readFloats()

    override fun close() {
        target.close()
        context.close()
    }
}

/** The reference in double precision, with [grid]×[grid] samples a pixel; needs no OpenGL. */
public class ReferenceCanvas(
    private val size: Size,
    private val grid: Int,
) : Canvas {
    private lateinit var picture: ReferencePicture

    init {
        // A Java array ends at 2³¹ elements, and a picture has four a pixel.
        val pixels = Int.MAX_VALUE / 4
        if (size.width.toLong() * size.height > pixels) {
            throw InputError("size ${size.width}x${size.height} cannot be rendered: give at most $pixels pixels in all.")
        }
    }

    override fun draw(scene: Scene) {
        picture = ReferenceRenderer(scene.frame(), size.width, size.height).render(grid)
    }

    override fun read(): ImageData = picture.toImageData()

    override fun readFloats(): FloatImage = picture.toFloatImage()

    override fun close(): Unit = Unit
}
