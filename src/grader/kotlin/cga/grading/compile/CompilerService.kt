package cga.grading.compile

import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Path
import kotlin.io.path.createFile
import kotlin.io.path.exists
import kotlin.io.path.moveTo
import kotlin.io.path.readLines
import kotlin.io.path.writeText
import kotlin.system.exitProcess

/**
 * The inside of a [SharedCompiler]: compiles in one process what is asked for, one request after another. Both sides share a folder and
 * nothing else: a request is the file `0.request`, then `1.request`, …, with the compiler's arguments as its lines, and the answer beside it
 * is the compiler's exit code by name.
 *
 * Arguments: the folder, and the compiler's main class.
 */
public object CompilerService {
    private const val PAUSE = 10L

    /** Whoever asked may have been killed: nobody is waited for longer. */
    private const val IDLE_SECONDS = 300

    /** Answers requests until nobody asks any more. */
    @JvmStatic
    public fun main(arguments: Array<String>) {
        val (folder, compiler) = arguments
        SharedFiles(Path.of(folder)).run {
            ready.createFile()
            var number = 0
            while (isAsked(number)) {
                val answer = compile(compiler, request(number).readLines())
                // Whole or not at all: the other side looks for it all the time.
                unfinished.apply { writeText(answer) }.moveTo(answer(number))
                // What it takes while it waits others cannot have.
                System.gc()
                number++
            }
        }
        // The compiler leaves threads behind.
        exitProcess(0)
    }

    private fun SharedFiles.isAsked(number: Int): Boolean {
        val start = System.nanoTime()
        while (!request(number).exists()) {
            if (System.nanoTime() - start > IDLE_SECONDS * 1_000_000_000L) return false
            Thread.sleep(PAUSE)
        }
        return true
    }

    /** The compiler is not on the grader's own class path: it is found by its name. */
    private fun compile(name: String, arguments: List<String>): String {
        val compiler = Class.forName(name)
        val exec = compiler.getMethod("exec", PrintStream::class.java, Array<String>::class.java)
        return "${exec.invoke(
            compiler.getConstructor().newInstance(),
            PrintStream(OutputStream.nullOutputStream()),
            arguments.toTypedArray(),
        )}"
    }
}

/** The files by which [SharedCompiler] and [CompilerService] speak to each other, in [folder]. */
internal class SharedFiles(
    private val folder: Path,
) {
    /** There is somebody who reads requests. */
    val ready: Path = folder.resolve("ready")
    val unfinished: Path = folder.resolve("unfinished")

    /** Where the sources of request [number] lie. */
    fun sources(number: Int): Path = folder.resolve("$number")

    fun request(number: Int): Path = folder.resolve("$number.request")

    fun answer(number: Int): Path = folder.resolve("$number.answer")

    /** What came of it. */
    fun jar(number: Int): Path = folder.resolve("$number.jar")
}
