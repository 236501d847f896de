package cga.testing

import java.io.File
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.createTempDirectory

/** What a process of ours ended with and said. */
class CgaProcess private constructor(
    val exitCode: Int,
    val out: String,
    val err: String,
) {
    override fun toString(): String = "exit code $exitCode\nstdout: $out\nstderr: $err"

    companion object {
        private const val LIMIT_SECONDS = 60L

        /**
         * Runs the program with [args] in [directory], with the shaders and assets of [home].
         *
         * @param env variables to add to this process's own; null removes one.
         */
        fun cga(
            vararg args: String,
            directory: Path,
            home: Path = projectRoot.toPath(),
            env: Map<String, String?> = emptyMap(),
        ): CgaProcess = java("cga.cli.MainKt", args.toList(), directory, home, env)

        /** Runs the class [main], one of the tests' too, on the tests' own class path; otherwise as [cga]. */
        fun java(
            main: String,
            args: List<String>,
            directory: Path,
            home: Path = projectRoot.toPath(),
            env: Map<String, String?> = emptyMap(),
        ): CgaProcess {
            // Files, not pipes: nobody has to read them while the process runs. Outside of directory: the tests look at what is left there.
            val logs = createTempDirectory("cga-logs").toFile()
            try {
                return start(command(main, args, home), directory, env, logs)
            } finally {
                logs.deleteRecursively()
            }
        }

        private fun start(
            command: List<String>,
            directory: Path,
            env: Map<String, String?>,
            logs: File,
        ): CgaProcess {
            val out = logs.resolve("out")
            val err = logs.resolve("err")
            val builder = ProcessBuilder(command).directory(directory.toAbsolutePath().toFile()).redirectOutput(out).redirectError(err)
            for ((name, value) in env) if (value == null) builder.environment() -= name else builder.environment()[name] = value
            val process = builder.start()
            process.outputStream.close()
            if (!process.waitFor(LIMIT_SECONDS, SECONDS)) {
                process.destroyForcibly().waitFor()
                error("still running after $LIMIT_SECONDS s: $command\nstdout: ${out.readText()}\nstderr: ${err.readText()}")
            }
            return CgaProcess(process.exitValue(), out.readText(), err.readText())
        }

        /** The command that starts [main]: as the launcher does; without the optimising compiler short runs are faster. */
        fun command(
            main: String,
            args: List<String>,
            home: Path,
        ): List<String> {
            val java =
                listOf(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-XX:TieredStopAtLevel=1",
                    "-XX:+UseSerialGC",
                    "-Xshare:auto",
                    "-Djava.awt.headless=true",
                    "-Dcga.home=$home",
                ) + nativeAccess()
            val classPath = absoluteClassPath()
            return java + ProgramArchive.options(java - "-Dcga.home=$home", classPath) + listOf("-cp", classPath, main) + args
        }

        private fun nativeAccess(): List<String> =
            if (Runtime.version().feature() < 24) {
                emptyList()
            } else {
                listOf("--enable-native-access=ALL-UNNAMED", "--sun-misc-unsafe-memory-access=allow")
            }

        private fun absoluteClassPath(): String =
            System.getProperty("java.class.path").split(File.pathSeparator).joinToString(File.pathSeparator) { File(it).absolutePath }
    }
}
