package cga.cli

import cga.testing.Need
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeFalse
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import java.io.File
import java.util.concurrent.TimeUnit

/** The launcher `./cga`, tried by the shell tests in `tests/launcher` on stubs of all that it calls. */
@Slow
class LauncherTest {
    @BeforeEach
    fun `there is a shell`() = assumeFalse(System.getProperty("os.name").startsWith("Windows"), "the launcher is for POSIX shells")

    @ParameterizedTest
    @MethodSource("scripts")
    fun `the shell test passes`(script: String) = run("sh", script)

    @Test
    fun `shellcheck finds nothing`() {
        val found = System.getenv("PATH").split(File.pathSeparator).any { File(it, "shellcheck").canExecute() }
        if (!found) Need.SHELLCHECK.skip("needs shellcheck: apt-get install shellcheck")
        run("shellcheck", "-x", "-P", "SCRIPTDIR", "-P", ".", "cga", ".ci/run", *scripts().toTypedArray())
    }

    private fun run(vararg command: String) {
        val log = File.createTempFile("launcher", ".log")
        try {
            val process =
                ProcessBuilder(*command)
                    .directory(projectRoot)
                    .redirectErrorStream(true)
                    .redirectOutput(log)
                    .start()
            val ended = process.waitFor(300, TimeUnit.SECONDS)
            if (!ended) process.destroyForcibly()
            assertTrue(ended) { "still running after five minutes: ${command.toList()}\n${log.readText()}" }
            assertEquals(0, process.exitValue()) { log.readText() }
        } finally {
            log.delete()
        }
    }

    private companion object {
        /** All but the sandbox, which they share. */
        @JvmStatic
        fun scripts(): List<String> =
            projectRoot
                .resolve("tests/launcher")
                .listFiles { file -> file.extension == "sh" && file.name != "sandbox.sh" }
                .orEmpty()
                .map { it.relativeTo(projectRoot).path }
                .sorted()
    }
}
