package cga.testing

import cga.framework.image.ImageData
import java.lang.ProcessBuilder.Redirect.DISCARD
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.util.Arrays
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.Path
import kotlin.io.path.createTempDirectory
import kotlin.io.path.deleteRecursively
import kotlin.io.path.isExecutable

/** An X display of its own that nobody sees: xdotool is its hands, its framebuffer its eyes. [Openbox] manages its windows, or nobody. */
class Xvfb private constructor(private val size: String) : AutoCloseable {
    private val folder = createTempDirectory("cga-xvfb")

    // On a display number that it chooses, and says once clients may come; the screen is mapped to a file in the folder.
    private val server =
        ProcessBuilder("Xvfb -displayfd 1 -screen 0 ${size}x24 -noreset -nolisten tcp -fbdir $folder".split(' '))
            .redirectError(DISCARD)
            .start()

    /** Variables that lead a program's window here, away from a Wayland desktop that the tests may be started in. */
    val variables: Map<String, String> =
        mapOf(
            "DISPLAY" to ":" + (server.inputReader().readLine() ?: error("Xvfb ended with exit code ${server.waitFor()}")),
            "XDG_SESSION_TYPE" to "x11",
        )

    /** Calls xdotool with the words of [command] and returns what it says; a failure of its own is an empty answer. */
    fun xdotool(command: String): String {
        val process =
            ProcessBuilder(listOf("xdotool") + command.split(' '))
                .apply { environment() += variables }
                .redirectError(DISCARD)
                .start()
        val answer = process.inputStream.readAllBytes().decodeToString()
        check(process.waitFor(10, SECONDS)) { "xdotool $command does not end" }
        return answer.trim()
    }

    /** The [width] × [height] pixels in the screen's upper left corner, where windows appear as long as nobody manages them. */
    fun screen(
        width: Int,
        height: Int,
    ): ImageData {
        val file = ByteBuffer.wrap(Files.readAllBytes(folder.resolve("Xvfb_screen0")))
        // An XWD file: a header of big-endian numbers, a colour map of 12 bytes an entry, and pixels 0x00RRGGBB in the server's byte order.
        val headerSize = file.getInt(0)
        val littleEndian = file.getInt(4 * 7) == 0
        val bytesPerLine = file.getInt(4 * 12)
        val colors = file.getInt(4 * 19)
        check(file.getInt(4 * 11) == 32) { "the screen has ${file.getInt(4 * 11)} bits a pixel, not 32" }
        if (littleEndian) file.order(ByteOrder.LITTLE_ENDIAN)
        val rgba = ByteBuffer.allocate(4 * width * height)
        for (y in 0 until height) {
            for (x in 0 until width) rgba.putInt((file.getInt(headerSize + 12 * colors + y * bytesPerLine + 4 * x) shl 8) or 0xFF)
        }
        return ImageData(width, height, rgba.array())
    }

    /** Whether [picture] is to be seen anywhere on the screen, to the last bit. */
    fun shows(picture: ImageData): Boolean {
        val (width, height) = size.split('x').map(String::toInt)
        val screen = screen(width, height)
        return (0..height - picture.height).any { top -> (0..width - picture.width).any { left -> screen.has(picture, left, top) } }
    }

    // From below: what is far up is black in most pictures.
    private fun ImageData.has(
        part: ImageData,
        left: Int,
        top: Int,
    ) = (part.height - 1 downTo 0).all { y ->
        val (own, its) = 4 * ((top + y) * width + left) to 4 * y * part.width
        Arrays.equals(rgba, own, own + 4 * part.width, part.rgba, its, its + 4 * part.width)
    }

    @OptIn(ExperimentalPathApi::class)
    override fun close() {
        server.destroy()
        server.waitFor()
        folder.deleteRecursively()
    }

    companion object {
        /** A new display of [size] pixels. Where Xvfb or xdotool is missing the test is skipped, and in CI it fails. */
        fun openOrSkip(size: String = "1280x800"): Xvfb {
            val missing = listOf("Xvfb", "xdotool").filterNot(::isInstalled)
            if (missing.isNotEmpty()) Need.XVFB.skip("needs ${missing.joinToString(" and ")}: apt-get install xvfb xdotool")
            return Xvfb(size)
        }

        /** Whether [program] can be called by its name. */
        internal fun isInstalled(program: String): Boolean =
            System.getenv("PATH").split(':').any { Path(it, program).isExecutable() }
    }
}
