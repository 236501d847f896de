package cga.exercise.game

import cga.framework.image.ImageData
import cga.testing.CgaProcess
import cga.testing.Xvfb
import cga.testing.projectRoot
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.exists

/**
 * `cga run` in a process of its own on a virtual display, with nobody but a test at mouse and keyboard.
 *
 * @param directory where it runs and leaves its screenshots.
 * @param home the folder of its shaders and assets.
 * @param variables of its environment, besides the display's.
 */
class RunningGame(
    private val display: Xvfb,
    private val directory: Path,
    options: String,
    home: Path = projectRoot.toPath(),
    private val variables: Map<String, String> = emptyMap(),
) : AutoCloseable {
    private val outFile = directory.resolve("out.txt").toFile()
    private val errFile = directory.resolve("err.txt").toFile()
    private val process = start(options, home)
    private var screenshots = 0

    // The program names the step in its title when it is ready for input; until then keys are lost.
    private val window = await("the window") { display.xdotool("search --name ^CGA.Lights.*4").ifEmpty { null } }

    val out: String get() = outFile.readText()
    val err: String get() = errFile.readText()
    val title: String get() = display.xdotool("getwindowname $window")

    fun press(key: String) {
        display.xdotool("key $key")
    }

    /** Runs [block] while [key] is held down. */
    fun <T> holding(
        key: String,
        block: () -> T,
    ): T {
        display.xdotool("keydown $key")
        return try {
            block()
        } finally {
            display.xdotool("keyup $key")
        }
    }

    /** Moves the mouse [dx] pixels to the right, less than half the window: there the captured cursor meets its edge. */
    fun moveMouse(dx: Int) {
        display.xdotool("mousemove_relative -- $dx 0")
    }

    /** As [moveMouse], with the left button held down. */
    fun drag(dx: Int) {
        display.xdotool("mousedown 1")
        moveMouse(dx)
        display.xdotool("mouseup 1")
    }

    fun resize(size: Pair<Int, Int>) {
        display.xdotool("windowsize $window ${size.first} ${size.second}")
    }

    /** Lets the window manager minimise the window. */
    fun minimise() {
        display.xdotool("windowminimize $window")
        await("the window gone") { true.takeIf { window !in display.xdotool("search --onlyvisible --name ^CGA.Lights") } }
    }

    /** Lets the window manager show the window in front of all others, and give it the keyboard. */
    fun activate() {
        display.xdotool("windowactivate $window")
        await("the window in front") { true.takeIf { display.xdotool("getactivewindow") == window } }
    }

    /** Takes the keyboard away, moves the mouse out of the window, and gives the keyboard back. */
    fun loseFocusAndRegainIt() {
        display.xdotool("windowfocus ${display.xdotool("search --maxdepth 0 .*")}")
        // As long as the window has not noticed, it holds the cursor inside.
        await("the cursor outside of the window") {
            display.xdotool("mousemove 1200 700")
            display.xdotool("getmouselocation").takeIf { it.startsWith("x:1200 y:700") }
        }
        display.xdotool("windowfocus $window")
    }

    /** F12's picture. Input comes in order, so it shows what everything before has done. */
    fun screenshot(): ImageData {
        val file = directory.resolve("screenshot-%03d.png".format(++screenshots))
        press("F12")
        await(file.toString()) { file.takeIf { it.exists() } }
        return ImageData.read(file.toAbsolutePath().toString())
    }

    /** The first answer of [attempt] that is not null; an [AssertionError] if none comes or the program ends before. */
    fun <T : Any> await(
        what: String,
        attempt: () -> T?,
    ): T {
        val deadline = System.nanoTime() + SECONDS.toNanos(LIMIT_SECONDS)
        while (System.nanoTime() < deadline && process.isAlive) {
            attempt()?.let { return it }
            Thread.sleep(20)
        }
        fail("$what did not come within $LIMIT_SECONDS s")
    }

    /** Waits for the program's own end. */
    fun exitCode(): Int {
        if (!process.waitFor(LIMIT_SECONDS, SECONDS)) fail("the program did not end")
        return process.exitValue()
    }

    override fun close() {
        process.destroyForcibly().waitFor()
    }

    // The process is ended here too, since nobody closes what fails while it is made.
    private fun fail(message: String): Nothing {
        val running = process.isAlive
        close()
        throw AssertionError("$message, running: $running\nstdout: $out\nstderr: $err")
    }

    private fun start(
        options: String,
        home: Path,
    ): Process {
        val command = CgaProcess.command("cga.cli.MainKt", listOf("run") + options.split(' '), home)
        val builder = ProcessBuilder(command).directory(directory.toFile()).redirectOutput(outFile).redirectError(errFile)
        // It draws as long as it runs, picture after picture: on one thread, which leaves a core to other tests.
        builder.environment() += display.variables + mapOf("LIBGL_ALWAYS_SOFTWARE" to "1", "LP_NUM_THREADS" to "1") + variables
        return builder.start()
    }

    private companion object {
        const val LIMIT_SECONDS = 30L
    }
}
