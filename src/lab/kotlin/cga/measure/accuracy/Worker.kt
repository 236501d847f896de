package cga.measure.accuracy

import cga.framework.InputError
import cga.measure.ChildJvm
import java.io.IOException

/**
 * A JVM of its own that measures when it is asked to: what it runs in, environment or system properties, is read once a process.
 *
 * It gets one line and answers with one. Many can live beside each other, so that what they measure can be interleaved.
 */
internal class Worker(
    private val name: String,
    main: String,
    args: List<String>,
    properties: Map<String, String> = emptyMap(),
    environment: Map<String, String?> = emptyMap(),
) : AutoCloseable {
    private val process = start(ChildJvm.command(main, args, properties), environment)
    private val requests = process.outputWriter()
    private val answers = process.inputReader()

    /** The answer to [request]. Throws [InputError] where the worker ended instead; it has said why on standard error. */
    fun ask(request: String): String {
        try {
            requests.write("$request\n")
            requests.flush()
        } catch (_: IOException) {
            // Nobody reads it any more, and so nobody answers either.
        }
        return answer()
    }

    /** The next line that the worker says. */
    fun answer(): String =
        answers.readLine() ?: throw InputError("$name ended with exit code ${process.waitFor()} and no answer, see above.")

    override fun close() {
        runCatching { requests.close() }
        process.waitFor()
    }

    private companion object {
        fun start(
            command: List<String>,
            environment: Map<String, String?>,
        ): Process {
            val builder = ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT)
            for ((name, value) in environment) if (value == null) builder.environment() -= name else builder.environment()[name] = value
            return builder.start()
        }
    }
}
