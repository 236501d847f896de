package cga.measure.speed

import cga.framework.Home
import cga.framework.InputError
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path

/** What makes a short run faster: options of the JVM. */
internal class Lever(
    val name: String,
    val options: List<String>,
    /** What takes their place where the lever is off. */
    val off: List<String> = emptyList(),
)

/** The JVM as the launcher starts it for a picture. */
internal class LauncherJvm private constructor(
    private val fixed: List<String>,
    val levers: List<Lever>,
) {
    /** The command with only [levers] on, and [words] after the JVM's options. */
    fun command(
        levers: List<Lever>,
        words: List<String>,
    ): List<String> = listOf(JAVA) + fixed + this.levers.flatMap { if (it in levers) it.options else it.off } + words

    companion object {
        private val JAVA = Path.of(System.getProperty("java.home"), "bin", "java").toString()

        /** The launcher itself. Throws [InputError] where it is not there. */
        fun launcher(): Path {
            val launcher = Home.resolve("cga")
            if (!Files.isExecutable(launcher)) throw InputError("the launcher $launcher is not there: start this through ./cga bench.")
            return launcher
        }

        /** From this process' own options, which the launcher gave it as well. */
        fun ofThisProcess(): LauncherJvm {
            val own = ManagementFactory.getRuntimeMXBean().inputArguments
            val archive = own.filter { it.startsWith("-XX:SharedArchiveFile=") }
            val cooked = own.filter { it.startsWith("-Dcga.cooked=") }
            val natives = own.filter { it.startsWith("-Dcga.natives=") }
            val levers =
                listOf(
                    Lever("the archive of classes", archive, listOf("-Xshare:off")),
                    Lever("the cooked model and textures", cooked),
                    Lever("LWJGL's libraries unpacked once", natives),
                    Lever("the JIT compiler and the heap for short runs", SHORT),
                )
            return LauncherJvm(
                own - (archive + cooked + natives + SHORT).toSet() + listOf("-cp", System.getProperty("java.class.path")),
                levers,
            )
        }

        // As the launcher has them for `render`.
        private val SHORT =
            listOf("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-XX:Tier3BackEdgeThreshold=3000", "-Xms128m", "-Xmn96m")
    }
}
