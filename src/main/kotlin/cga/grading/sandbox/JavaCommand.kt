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
        /** Short runs: one collector thread, the quick compiler, no files beside the job's own. Without core dumps a crash would be an exit. */
        private val COMMON = listOf(
            "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-XX:-UsePerfData", "-Xshare:auto", "-XX:ErrorFile=/dev/null",
            "-Djava.awt.headless=true", "-Dfile.encoding=UTF-8",
        )

        /** Mesa in software, no newer than what the course asks for, with no cache that outlives the job. */
        public val MESA: Map<String, String> = mapOf(
            "LIBGL_ALWAYS_SOFTWARE" to "1",
            "MESA_GL_VERSION_OVERRIDE" to "3.3",
            "MESA_GLSL_VERSION_OVERRIDE" to "330",
            "MESA_SHADER_CACHE_DISABLE" to "true",
            "MESA_GLSL_CACHE_DISABLE" to "true",
        )
    }
}
