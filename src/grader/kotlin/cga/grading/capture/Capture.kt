package cga.grading.capture

import org.lwjgl.opengl.GL33C.GL_REPEAT

/**
 * Everything that one run of a submission handed to OpenGL, as plain data: enough to draw its frames again without the submission.
 *
 * The worker writes one; whoever reads one must not believe it. Immutable: nobody changes the arrays.
 *
 * @param width of the window's framebuffer in pixels, likewise [height].
 * @param samples of the window's framebuffer, 0 for none.
 * @param buffers contents of buffer objects; draws name them by their number in this list. The same contents appear once.
 * @param callers who called OpenGL: chains of calls in the submission's own code, each `package/File.kt:line`, innermost first. It is a
 * stranger's text, to be shown and never believed.
 */
public class Capture(
    public val width: Int,
    public val height: Int,
    public val programs: List<CapturedProgram>,
    public val buffers: List<ByteArray>,
    public val textures: List<CapturedTexture>,
    public val frames: List<CapturedFrame>,
    public val events: List<CapturedEvent>,
    public val samples: Int = 0,
    public val callers: List<List<String>> = emptyList(),
) {
    /** The chain of calls with the number [caller]; empty for none. */
    public fun chain(caller: Int): List<String> = callers.getOrNull(caller).orEmpty()

    /** This capture with other [programs] and [frames]. */
    public fun with(
        programs: List<CapturedProgram> = this.programs,
        frames: List<CapturedFrame> = this.frames,
    ): Capture = Capture(width, height, programs, buffers, textures, frames, events, samples, callers)

    /** Every draw of every frame, in their order. */
    public val draws: List<CapturedDraw> get() = frames.flatMap { it.draws }

    /** Those of [program]. */
    public fun drawsOf(program: Int): List<CapturedDraw> = frames.flatMap { it.drawsOf(program) }
}

/**
 * A linked program.
 *
 * @param attributes vertex attributes that are active, by name, with their locations.
 * @param outputs fragment outputs bound by the program to a colour number other than the compiler's, by name.
 * @param substituted whether these are not the submission's own sources but stand-ins for some that did not compile or link: they declare
 * the same inputs, outputs and uniforms and draw nothing of use.
 * @param vertexFile the file with the same lines, from the folder that the submission ran in; null where none is known. Likewise
 * [fragmentFile].
 */
public class CapturedProgram(
    public val vertexSource: String,
    public val fragmentSource: String,
    public val attributes: Map<String, Int>,
    public val outputs: Map<String, Int> = emptyMap(),
    public val substituted: Boolean = false,
    public val vertexFile: String? = null,
    public val fragmentFile: String? = null,
) {
    /** This program with the files that its sources are in. */
    public fun inFiles(
        vertex: String?,
        fragment: String?,
    ): CapturedProgram = CapturedProgram(vertexSource, fragmentSource, attributes, outputs, substituted, vertex, fragment)
}

/**
 * A 2D texture, or a cube map.
 *
 * @param levels RGBA, 8 bits a channel, first row at the bottom as OpenGL has it; level i is max(1, width >> i) wide. A cube map's levels are
 * its six faces one after the other, in the order of OpenGL's constants.
 * @param wrapS as all other parameters here OpenGL's own constant.
 * @param srgb whether the texels are sRGB-encoded and are decoded when sampled.
 * @param wrapR of a cube map; of a 2D texture it means nothing.
 * @param depth the format of a texture of depths, whose levels are one float a texel in this machine's order; 0 for colours.
 * @param border RGBA of what lies outside where it is clamped to its border.
 */
public class CapturedTexture(
    public val width: Int,
    public val height: Int,
    public val levels: List<ByteArray>,
    public val wrapS: Int,
    public val wrapT: Int,
    public val minFilter: Int,
    public val magFilter: Int,
    public val maxAnisotropy: Float = 1f,
    public val srgb: Boolean = false,
    public val isCube: Boolean = false,
    public val wrapR: Int = GL_REPEAT,
    public val depth: Int = 0,
    public val border: List<Float>? = null,
) {
    /** How many pictures a level is made of. */
    public val faces: Int get() = if (isCube) CUBE_FACES else 1

    private companion object {
        const val CUBE_FACES = 6
    }
}

/**
 * One picture.
 *
 * @param moment which moment of the [Script] it shows.
 * @param time seconds since the start.
 * @param picture RGBA, 8 bits a channel, top row first; null for a frame that was noted without being drawn.
 */
public class CapturedFrame(
    public val moment: Moment,
    public val time: Double,
    public val steps: List<CapturedStep>,
    public val picture: ByteArray?,
) {
    /** The steps that draw. */
    public val draws: List<CapturedDraw> get() = steps.filterIsInstance<CapturedDraw>()

    /** Those of [program]. */
    public fun drawsOf(program: Int): List<CapturedDraw> = draws.filter { it.program == program }
}

/** What changes the picture, in order. */
public sealed interface CapturedStep

/**
 * Which part of the framebuffer may be written.
 *
 * @param scissor x, y, width and height in pixels, null for all.
 * @param channels one bit each for red, green, blue and alpha, red being 1.
 */
public data class WriteMask(
    public val scissor: List<Int>?,
    public val channels: Int,
) {
    public companion object {
        public const val ALL_CHANNELS: Int = 15

        /** Everything may be written. */
        public val ALL: WriteMask = WriteMask(null, ALL_CHANNELS)
    }
}

/** glClear. @param mask `GL_COLOR_BUFFER_BIT` and its like. */
public class CapturedClear(
    public val mask: Int,
    public val color: FloatArray,
    public val depth: Double,
    public val writes: WriteMask = WriteMask.ALL,
) : CapturedStep

/**
 * A draw call and all that it reads.
 *
 * @param program number in [Capture.programs].
 * @param uniforms every active uniform of the program, arrays and structs written out: one entry an element.
 * @param textures texture unit → number in [Capture.textures], for the units that the program's samplers name.
 * @param indices number in [Capture.buffers], or null for glDrawArrays.
 * @param indexType `GL_UNSIGNED_INT` and its like.
 * @param first byte offset into the indices, or first vertex.
 * @param callers who made the call, and who bound what it uses.
 */
public class CapturedDraw(
    public val program: Int,
    public val mode: Int,
    public val count: Int,
    public val attributes: List<CapturedAttribute>,
    public val indices: Int?,
    public val indexType: Int,
    public val first: Long,
    public val baseVertex: Int,
    public val instances: Int,
    public val uniforms: List<UniformValue>,
    public val textures: Map<Int, Int>,
    public val state: DrawState,
    public val callers: DrawCallers = DrawCallers.NONE,
) : CapturedStep

/**
 * Who made a draw what it is; numbers in [Capture.callers], −1 where nobody is known.
 *
 * @param draw who made the call, [program] who put the program in use.
 * @param textures texture unit → who bound what is there.
 */
public class DrawCallers(
    public val draw: Int,
    public val program: Int,
    public val textures: Map<Int, Int>,
) {
    public companion object {
        /** Nobody is known. */
        public val NONE: DrawCallers = DrawCallers(-1, -1, emptyMap())
    }
}

/**
 * One enabled vertex attribute, as glVertexAttribPointer was told.
 *
 * @param buffer number in [Capture.buffers].
 */
public class CapturedAttribute(
    public val location: Int,
    public val size: Int,
    public val type: Int,
    public val normalized: Boolean,
    public val stride: Int,
    public val offset: Long,
    public val buffer: Int,
)

/**
 * The value of one uniform (one element, where it is an array).
 *
 * @param name as OpenGL writes it: `lights[2].color`.
 * @param type `GL_FLOAT_VEC3` and its like; samplers hold their unit, booleans 0 or 1.
 * @param numbers matrices column by column.
 * @param caller who sent it, a number in [Capture.callers]; −1 where nobody is known.
 */
public class UniformValue(
    public val name: String,
    public val type: Int,
    public val numbers: FloatArray,
    public val caller: Int = -1,
)

/** The fixed-function state that decides which fragments arrive and how they are mixed; OpenGL's own constants. */
public data class DrawState(
    public val viewport: List<Int>,
    public val depthTest: Boolean,
    public val depthFunc: Int,
    public val depthMask: Boolean,
    public val cullFace: Boolean,
    public val cullMode: Int,
    public val frontFace: Int,
    public val blend: Boolean,
    public val blendSource: Int,
    public val blendDestination: Int,
    public val polygonMode: Int,
    public val framebufferSrgb: Boolean,
    public val writes: WriteMask = WriteMask.ALL,
)

/**
 * Something that happened beside the drawing.
 *
 * @param frame number in [Capture.frames] of the frame it happened in; −1 before the first.
 * @param text what it is about (a uniform's name, a GL function, a log), at most 2000 characters.
 * @param caller who made the call that it is about, a number in [Capture.callers]; −1 where nobody is known.
 */
public class CapturedEvent(
    public val kind: EventKind,
    public val frame: Int,
    public val text: String,
    public val caller: Int = -1,
)

/** Kinds of [CapturedEvent]. */
public enum class EventKind {
    /** glGetUniformLocation answered −1; the text is the name asked for. */
    UNIFORM_ABSENT,

    /** A glUniform call without a program in use, or for another program; the text is the function. */
    UNIFORM_WITHOUT_PROGRAM,

    /** OpenGL reported an error; the text is its name and the function. */
    GL_ERROR,

    /** A shader did not compile; the text is the stage and the driver's log. */
    SHADER_FAILED,

    /** A program did not link; the text is the driver's log. */
    LINK_FAILED,

    /** The submission threw; the text is the exception with its first lines of the submission's own. */
    EXCEPTION,

    /** A draw or a texture that a capture cannot hold; the text says which. */
    NOT_CAPTURED,

    /** A draw samples a texture that lacks mipmaps which its filter asks for: OpenGL gives black; the text is the sampler. */
    TEXTURE_INCOMPLETE,

    /** A file that the submission asked for was not there and a stand-in was given; the text is its path. */
    FILE_MISSING,

    /** A vec3 was sent twice between two draws with different values: nothing was drawn with the first; the text is its name. */
    UNIFORM_OVERWRITTEN,

    /**
     * A texture has the texels of a file; the text is its number in [Capture.textures], or `-` for a file that none has, and the file's name,
     * with a space between them.
     */
    TEXTURE_FILE,

    /** A shader did not compile as it is, and did when it was said in other words; the text is the stage and the driver's log. */
    SHADER_DIALECT,

    /** A texture or a sampler asked for anisotropic filtering, and is drawn without; the text is how much. */
    ANISOTROPY,
}
