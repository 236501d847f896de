package cga.measure.accuracy.choices

import cga.framework.InputError
import java.io.IOException
import java.lang.management.ManagementFactory
import java.nio.file.Path

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
    private val process = start(command(main, args, properties), environment)
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

        fun command(
            main: String,
            args: List<String>,
            properties: Map<String, String>,
        ): List<String> {
            val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
            val home = System.getProperty("cga.home")?.let { mapOf("cga.home" to it) }.orEmpty()
            val options = (properties + home + ("java.awt.headless" to "true")).map { (name, value) -> "-D$name=$value" }
            return listOf(java) + nativeAccess() + options + listOf("-cp", System.getProperty("java.class.path"), main) + args
        }

        /** What newer JDKs want to be told, as this JVM was. */
        fun nativeAccess(): List<String> =
            ManagementFactory.getRuntimeMXBean().inputArguments.filter {
                it.startsWith("--enable-native-access") || it.startsWith("--sun-misc-unsafe-memory-access")
            }
    }
}
