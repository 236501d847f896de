package cga.measure

import java.io.File
import java.lang.management.ManagementFactory
import java.nio.file.Path

/** Another JVM with this one's program: what a process reads only once, its environment or JOML's options, takes one of its own. */
internal object ChildJvm {
    /** The command that runs the class [main] with [args], the same project files, the system [properties], and [classPath] in front. */
    fun command(
        main: String,
        args: List<String>,
        properties: Map<String, String> = emptyMap(),
        classPath: List<String> = emptyList(),
    ): List<String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val home = System.getProperty("cga.home")?.let { mapOf("cga.home" to it) }.orEmpty()
        val options = (properties + home + ("java.awt.headless" to "true")).map { (name, value) -> "-D$name=$value" }
        return listOf(java) + nativeAccess() + options +
            listOf("-cp", (classPath + System.getProperty("java.class.path")).joinToString(File.pathSeparator), main) +
            args
    }

    /** What newer JDKs want to be told, as this JVM was. */
    private fun nativeAccess(): List<String> =
        ManagementFactory.getRuntimeMXBean().inputArguments.filter {
            it.startsWith("--enable-native-access") || it.startsWith("--sun-misc-unsafe-memory-access")
        }
}
