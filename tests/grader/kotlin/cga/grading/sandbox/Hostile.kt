package cga.grading.sandbox

import cga.testing.Need
import java.net.URI
import java.nio.file.Path
import javax.tools.JavaFileObject
import javax.tools.SimpleJavaFileObject
import javax.tools.ToolProvider
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory

/** Jobs that misbehave, and the sandbox that they are put in. */
class Hostile : AutoCloseable {
    private val folder = createTempDirectory("hostile")
    val scratch: Path = folder.resolve("scratch").createDirectories()

    /** A folder beside the scratch folder, which no job may see. */
    val outside: Path = folder.resolve("outside").createDirectories()

    /** Runs shell [text]. */
    fun shell(
        text: String,
        limits: Limits = Limits(),
        sandbox: Sandbox = confined(),
        environment: Map<String, String> = emptyMap(),
    ): Outcome =
        sandbox.run(Job(listOf("/bin/sh", "-c", text), scratch, limits = limits, environment = environment))

    /** Runs Java whose `main` is [body]. */
    fun java(body: String, limits: Limits = Limits(), heapMegabytes: Int = 256, sandbox: Sandbox = confined()): Outcome {
        val classes = folder.resolve("classes").createDirectories()
        val source = "public class Main { public static void main(String[] args) throws Throwable { $body } }"
        val file = object : SimpleJavaFileObject(URI("string:///Main.java"), JavaFileObject.Kind.SOURCE) {
            override fun getCharContent(ignoreEncodingErrors: Boolean) = source
        }
        val compiler = ToolProvider.getSystemJavaCompiler()
        check(
            compiler.getTask(null, null, null, listOf("-nowarn", "-d", "$classes"), null, listOf(file)).call(),
        ) { "does not compile: $source" }
        val command = JavaCommand(listOf(classes), "Main", heapMegabytes = heapMegabytes).command()
        return sandbox.run(Job(command, scratch, readOnly = listOf(classes), limits = limits))
    }

    override fun close() = Scratch.delete(folder)

    companion object {
        /** The sandbox; where there is none the test is skipped, but in CI it fails. */
        fun confined(): Sandbox {
            Sandbox.unavailable?.let { Need.SANDBOX.skip(it) }
            return Sandbox.confined()
        }

        /** The sandbox as an older bubblewrap makes it. */
        fun confinedWithoutBounds(): Sandbox {
            confined()
            return ConfinedRun(Confinement.find().getOrThrow().withoutBounds())
        }

        /** Whether a process with [marker] in its command line lives on this machine. */
        fun isAlive(marker: String): Boolean =
            Path.of("/proc").toFile().listFiles().orEmpty().any { process ->
                process.name.toLongOrNull() != null &&
                    runCatching { process.resolve("cmdline").readText() }.getOrDefault("").contains(marker)
            }
    }
}
