package cga.grading.compile

import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedDeque

/** As many [SharedCompiler]s as submissions are being compiled at a time, made by [make] when they are needed. Safe to use from several threads. */
internal class SharedCompilers(
    private val make: () -> SharedCompiler,
) : AutoCloseable {
    private val idle = ConcurrentLinkedDeque<SharedCompiler>()

    /** As [SharedCompiler.compiles]. */
    fun compiles(sources: Collection<Path>, jar: Path): Boolean {
        val compiler = idle.poll() ?: make()
        try {
            return compiler.compiles(sources, jar)
        } finally {
            if (compiler.isUsable) idle.push(compiler) else compiler.close()
        }
    }

    override fun close() = generateSequence(idle::poll).forEach(SharedCompiler::close)
}
