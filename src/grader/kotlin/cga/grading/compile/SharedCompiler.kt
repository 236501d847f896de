package cga.grading.compile

import cga.framework.InputError
import cga.grading.sandbox.Job
import cga.grading.sandbox.Limits
import cga.grading.sandbox.SafeFiles
import cga.grading.sandbox.Sandbox
import cga.grading.sandbox.Scratch
import cga.grading.sandbox.Temporary
import java.io.IOException
import java.nio.file.Path
import kotlin.concurrent.thread
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.moveTo
import kotlin.io.path.name
import kotlin.io.path.writeBytes
import kotlin.io.path.writeLines

/**
 * A compiler that compiles one submission after another in a process of its own in [sandbox], as a compiler that has just started takes
 * five times as long. Compiling runs nothing of a submission's, and of others it sees nothing: their files are gone before the next comes.
 *
 * It can only say yes. Whatever else becomes of a request is no verdict: who asked has the submission compiled once more, by itself.
 *
 * @param own the class path of this program.
 * @param libraries what submissions are compiled against.
 */
internal class SharedCompiler(
    sandbox: Sandbox,
    private val compiler: KotlinCompiler,
    own: List<Path>,
    private val libraries: List<Path>,
) : AutoCloseable {
    private val scratch = Temporary.folder("compiler").toRealPath()
    private val files = SharedFiles(scratch)
    private val command = compiler.serviceCommand(own, CompilerService::class.java.name, scratch)
    private val job = Job(command, scratch, compiler.readable + own + libraries, limits = LIMITS)
    private val service = thread(isDaemon = true, name = "shared compiler") { live(sandbox) }
    private var requests = 0

    /** False once something went wrong other than a submission with errors: then it is to be closed. */
    var isUsable: Boolean = true
        private set

    private fun live(sandbox: Sandbox) {
        try {
            sandbox.run(job)
        } catch (_: InterruptedException) {
            // Closed.
        } catch (_: InputError) {
            // It did not start, so it gives no answers.
        }
    }

    /** Whether [sources] compile, each of which lies in a folder with a name of its own; then their classes are in [jar], which is made. */
    fun compiles(sources: Collection<Path>, jar: Path): Boolean {
        val number = requests++
        try {
            val answer = if (waitFor(files.ready)) answer(number, sources) else null
            isUsable = answer in UNHARMED
            if (answer == OK) jar.writeBytes(SafeFiles.read(scratch, files.jar(number).name, MOST_BYTES))
            return answer == OK
        } catch (_: IOException) {
            isUsable = false
        } catch (_: InputError) {
            isUsable = false
        } finally {
            Scratch.delete(files.sources(number))
            listOf(files.request(number), files.answer(number), files.jar(number)).forEach { it.deleteIfExists() }
        }
        return false
    }

    private fun answer(number: Int, sources: Collection<Path>): String? {
        val copies = sources.map { source ->
            val copy = files.sources(number).resolve(source.parent.name).createDirectories().resolve(source.name)
            copy.apply { writeBytes(SafeFiles.read(source.parent, source.name, LARGEST_SOURCE)) }
        }
        val request = scratch.resolve("asking").apply { writeLines(compiler.arguments(copies, libraries, files.jar(number))) }
        request.moveTo(files.request(number))
        if (!waitFor(files.answer(number))) return null
        return SafeFiles.read(scratch, files.answer(number).name, LONGEST_ANSWER).decodeToString()
    }

    private fun waitFor(file: Path): Boolean {
        val start = System.nanoTime()
        while (!file.exists()) {
            if (!service.isAlive || System.nanoTime() - start > PATIENCE) return false
            Thread.sleep(PAUSE)
        }
        return true
    }

    /** Kills the process and removes its folder. */
    override fun close() {
        service.interrupt()
        service.join()
        Scratch.delete(scratch)
    }

    private companion object {
        const val OK = "OK"

        /** After these the compiler is as it was. */
        val UNHARMED = setOf(OK, "COMPILATION_ERROR")

        /** Of its whole life. The submission that takes it beyond is compiled by itself, with limits of its own. */
        val LIMITS = Limits(wallSeconds = 1e6, cpuSeconds = 3600.0, lookSeconds = 0.5)

        /** Nanoseconds: ten times what a loaded machine needed for the first request, which is the slowest. */
        const val PATIENCE = 60_000_000_000
        const val PAUSE = 10L
        const val MOST_BYTES = 32L shl 20
        const val LONGEST_ANSWER = 100L
        const val LARGEST_SOURCE = 8L shl 20
    }
}
