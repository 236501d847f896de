package cga.measure.mutation

import cga.framework.InputError
import cga.framework.context.OffscreenContext
import cga.framework.image.ExrFile
import cga.framework.image.PngFile
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Picture
import cga.imaging.PictureFile
import cga.measure.ChildJvm
import cga.measure.golden.GoldenCase
import cga.measure.golden.GoldenCases
import org.lwjgl.opengl.GL33C.*
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Another machine, or this one made to draw like another: nothing is wrong with its pictures.
 *
 * @param title says which, in a few words.
 * @param environment variables of the process that draws.
 * @param mustPass whether the tolerant tier is made for it; where not, a tolerance that let it pass would let visible defects pass too.
 */
public class Renderer(
    public val title: String,
    private val environment: Map<String, String>,
    public val mustPass: Boolean = true,
) {
    /** What was drawn, and by whom, as OpenGL tells it. */
    internal class Drawn(
        val name: String,
        val pictures: List<Picture>,
    )

    /** Draws [cases] in a process of its own, for a driver reads its variables once. Throws [InputError] where that process fails. */
    internal fun draw(cases: List<GoldenCase>): Drawn {
        val folder = Files.createTempDirectory("cga-renderer")
        try {
            val command = ChildJvm.command(DrawCases::class.java.name, listOf("$folder") + cases.map { it.name })
            val builder = ProcessBuilder(command)
            // Mesa would take code from its cache that was made with other settings; a width of vectors that does not fit it crashes.
            builder.environment() += environment + ("MESA_SHADER_CACHE_DISABLE" to "true")
            val log = File("$folder/log")
            val exitCode = builder.redirectErrorStream(true).redirectOutput(log).start().waitFor()
            if (exitCode != 0) throw InputError("the renderer \"$title\" ended with exit code $exitCode: ${log.readText().trim()}")
            return Drawn(folder.resolve(DrawCases.NAME).readText(), cases.map { read(DrawCases.file(folder, it)) })
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    /** An OpenEXR file holds the framebuffer's alpha, which means nothing. */
    private fun read(file: Path): Picture = PictureFile.read(file).let { if (it is FloatPicture) FloatPicture.opaque(it.image) else it }

    public companion object {
        private const val CAPABILITIES = "GALLIUM_OVERRIDE_CPU_CAPS"

        /**
         * Settings of Mesa that make this processor draw like others. Mesa knows that variable for its own tests.
         *
         * @param mesa folder with the libraries of another Mesa, or null.
         */
        public fun all(mesa: Path?): List<Renderer> {
            val here =
                listOf(
                    Renderer("this machine again", emptyMap()),
                    Renderer("a processor with AVX2, no AVX-512", mapOf(CAPABILITIES to "avx2")),
                    Renderer("a processor with AVX, no AVX2", mapOf(CAPABILITIES to "avx")),
                    Renderer("this processor, vectors of 128 bits", mapOf("LP_NATIVE_VECTOR_WIDTH" to "128")),
                    Renderer("a processor with SSE4.1, no AVX", mapOf(CAPABILITIES to "sse4.1")),
                    Renderer("a processor with SSE2, no SSSE3", mapOf(CAPABILITIES to "sse2"), mustPass = false),
                    Renderer("this processor, textures filtered in floats", mapOf("GALLIVM_PERF" to "no_aos_sampling"), mustPass = false),
                )
            if (mesa == null) return here
            val path = "LD_LIBRARY_PATH" to "$mesa"
            return here + Renderer("this processor, another Mesa", mapOf(path)) +
                Renderer("a processor without AVX, another Mesa", mapOf(path, CAPABILITIES to "sse4.1"))
        }
    }
}

/** What the compare says of a [Renderer] that calls itself [name]. */
public class RendererResult internal constructor(
    public val renderer: Renderer,
    public val name: String,
    public val cases: List<CaseFigures>,
)

/** The program of the process that draws for a [Renderer]: arguments are a folder and names of cases. */
internal object DrawCases {
    /** The file with the renderer's name. */
    const val NAME = "renderer.txt"

    fun file(
        folder: Path,
        case: GoldenCase,
    ): Path = folder.resolve(case.name + if (case.float) ".exr" else ".png")

    @JvmStatic
    fun main(args: Array<String>) {
        val folder = Path.of(args.first())
        val wanted = args.drop(1).toSet()
        OffscreenContext.open().use {
            folder.resolve(NAME).writeText("${glGetString(GL_RENDERER)}, ${glGetString(GL_VERSION)}")
            for (case in GoldenCases.all.filter { it.name in wanted }) {
                val file = file(folder, case)
                when (val picture = CasePictures.draw(case, case.scene()).picture) {
                    is BytePicture -> PngFile.write(picture.image, file)
                    is FloatPicture -> ExrFile.write(picture.image, file)
                }
            }
        }
    }
}
