package cga.measure.twin

import cga.framework.Home
import cga.framework.InputError
import cga.framework.context.ContextKind
import cga.framework.image.ImageData
import cga.framework.reason
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readBytes

/** The C++ twin of the renderer, compiled from tests/glm/twin.cpp: the limit without a JVM. */
internal class Twin private constructor(private val program: Path) {
    /** How long a frame took, in milliseconds: by the clock, and of the thread that sends it to the driver. */
    data class FrameTime(
        val clock: Double,
        val thread: Double,
    )

    /** Draws what [recording] says and answers the picture; [own]: with GLM's matrices. */
    fun picture(
        recording: Path,
        kind: ContextKind,
        own: Boolean = false,
    ): ImageData {
        val (width, height) = Files.readAllLines(recording)[1].split(' ').drop(1).map { it.toInt() }
        val out = recording.resolveSibling("twin.rgba")
        run(recording, kind, own, listOf("--out", "$out"))
        return ImageData(width, height, out.readBytes())
    }

    /** How far GLM's matrices and lights are from the recorded ones: by uniform, in units of its largest number. */
    fun differences(
        recording: Path,
        kind: ContextKind,
    ): Map<String, Double> = columns(run(recording, kind, own = true), "difference").associate { (name, value) -> name to value.toDouble() }

    /** The times of [count] frames after the first; without [isCulling] back faces are drawn, too. */
    fun frameTimes(
        recording: Path,
        kind: ContextKind,
        count: Int,
        own: Boolean,
        isCulling: Boolean = true,
    ): List<FrameTime> =
        columns(run(recording, kind, own, listOf("--frames", "$count") + if (isCulling) emptyList() else listOf("--back-faces")), "frame")
            .map { (clock, thread) -> FrameTime(clock.toDouble(), thread.toDouble()) }

    /** The command that draws [recording] to [out], as a process to be timed. */
    fun command(
        recording: Path,
        kind: ContextKind,
        out: Path,
    ): List<String> = listOf("$program", "$recording", "--context", kind.name.lowercase(), "--out", "$out")

    private fun run(
        recording: Path,
        kind: ContextKind,
        own: Boolean,
        options: List<String> = emptyList(),
    ): List<String> {
        val ways = listOf("--context", kind.name.lowercase()) + if (own) listOf("--own") else emptyList()
        val command = listOf("$program", "$recording") + ways + options
        val process = ProcessBuilder(command).redirectErrorStream(true).start()
        val says = process.inputReader().readLines()
        if (process.waitFor() != 0) throw InputError("the C++ twin failed: ${says.joinToString(" ")}")
        return says
    }

    private fun columns(
        lines: List<String>,
        word: String,
    ): List<List<String>> = lines.filter { it.startsWith("$word ") }.map { it.split(' ').drop(1) }

    companion object {
        private const val SOURCE = "tests/glm/twin.cpp"
        private val OPTIONS = listOf("-std=c++17", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror")

        /** Compiles it into [folder]. Throws [InputError] where there is no compiler or no GLM, with what to install. */
        fun compile(folder: Path): Twin {
            val program = folder.resolve("twin")
            val command = listOf("g++") + OPTIONS + listOf("-o", "$program", "${Home.resolve(SOURCE)}", "-ldl", "-pthread")
            val compiler = ProcessBuilder(command).redirectErrorStream(true)
            compiler.environment()["LC_ALL"] = "C"
            val process =
                try {
                    compiler.start()
                } catch (e: IOException) {
                    throw NoCompiler("needs g++: apt-get install g++ libglm-dev (${e.reason()})", e)
                }
            val says = process.inputReader().readText()
            if (process.waitFor() == 0) return Twin(program)
            if (NO_GLM in says) throw NoCompiler(NO_GLM, null)
            throw InputError("$SOURCE does not compile: $says")
        }

        private const val NO_GLM = "needs GLM: apt-get install libglm-dev"
    }
}

/** This machine lacks what compiling the twin takes; the message says what to install. */
internal class NoCompiler(
    message: String,
    cause: Throwable?,
) : InputError(message, cause)
