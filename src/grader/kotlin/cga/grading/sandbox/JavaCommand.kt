package cga.grading.sandbox

import java.io.File
import java.nio.file.Path

/**
 * The command that starts the JVM that runs this program once more, with another class path, for a [Job].
 *
 * The class path must be readable inside ([Job.readOnly]). Native libraries are unpacked to the job's own temporary folder.
 *
 * @param heapMegabytes the most the heap may grow to; a JVM takes 100 to 300 MB besides.
 * @param options more options for the JVM.
 */
public class JavaCommand(
    private val classPath: List<Path>,
    private val mainClass: String,
    private val arguments: List<String> = emptyList(),
    private val heapMegabytes: Int = 512,
    private val options: List<String> = emptyList(),
) {
    /** As [Job.command] wants it. */
    public fun command(): List<String> =
        listOf("${Path.of(System.getProperty("java.home"), "bin", "java")}", "-Xmx${heapMegabytes}m") + COMMON + nativeAccess() + options +
            listOf("-cp", classPath.joinToString(File.pathSeparator), mainClass) + arguments

    private fun nativeAccess(): List<String> {
        val version = Runtime.version().feature()
        return listOfNotNull(
            "--enable-native-access=ALL-UNNAMED".takeIf { version >= 22 },
            "--sun-misc-unsafe-memory-access=allow".takeIf { version >= 23 },
        )
    }

    /** What every one of our jobs that draws needs. */
    public companion object {
        /** The options that every command has, whatever it runs: a class archive is made and used with the same. */
        internal fun commonOptions(): List<String> = COMMON

        /** Short runs: one collector thread, the quick compiler, no files beside the job's own. Without core dumps a crash would be an exit. */
        private val COMMON = listOf(
            "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-XX:-UsePerfData", "-Xshare:auto", "-XX:ErrorFile=/dev/null",
            "-Djava.awt.headless=true", "-Dfile.encoding=UTF-8",
        )

        /**
         * Mesa in software, no newer than what the course asks for, with no cache that outlives the job. Shaders may be of any version:
         * drivers compile those for who asks for OpenGL 3.3.
         *
         * Measured: shaders that are compiled without optimising draw the same bytes, and most of them draw only a few times. With a
         * submission for each core a second thread that draws gains nothing and waits for the first.
         */
        public val MESA: Map<String, String> = mapOf(
            "LIBGL_ALWAYS_SOFTWARE" to "1",
            "MESA_GL_VERSION_OVERRIDE" to "3.3",
            "MESA_GLSL_VERSION_OVERRIDE" to "460",
            "MESA_SHADER_CACHE_DISABLE" to "true",
            "MESA_GLSL_CACHE_DISABLE" to "true",
            "GALLIVM_PERF" to "nopt",
            "LP_NUM_THREADS" to "1",
        )

        /**
         * [MESA], with the machine code of shaders kept in [folder], which is this one job's: a shader that is linked into many programs
         * is compiled once.
         */
        public fun mesaCachingIn(folder: Path): Map<String, String> =
            MESA - setOf("MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE") + ("MESA_SHADER_CACHE_DIR" to "$folder")
    }
}
