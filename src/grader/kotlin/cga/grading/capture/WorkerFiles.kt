package cga.grading.capture

import cga.coach.calls.Interception
import java.io.File
import java.io.IOException
import java.net.URI
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.Path
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream

/**
 * What a process that runs a submission is made of, [StandIn] aside: the grader's own classes that it needs, and nothing else of ours, since the submission
 * has classes of the same names.
 */
public object WorkerFiles {
    /** Writes the worker's classes to the jar file [target]. Throws [IOException]. */
    public fun writeJar(target: Path) {
        JarOutputStream(Files.newOutputStream(target)).use { jar ->
            for ((part, one) in PARTS) {
                val home = Path.of(one.protectionDomain.codeSource.location.toURI())
                if (Files.isDirectory(home)) {
                    copy(home, part, jar)
                } else {
                    FileSystems.newFileSystem(URI("jar:${home.toUri()}"), emptyMap<String, Any>()).use { copy(it.getPath("/"), part, jar) }
                }
            }
            entry("META-INF/services/javax.sound.sampled.spi.MixerProvider", jar) { jar.write(SOUND.toByteArray()) }
        }
    }

    private fun copy(
        root: Path,
        part: String,
        jar: JarOutputStream,
    ) {
        val files = Files.list(root.resolve(part)).use { list -> list.filter { it.toString().endsWith(".class") }.toList() }
        for (file in files.sortedBy { it.fileName.toString() }) entry("$part/${file.fileName}", jar) { Files.copy(file, jar) }
    }

    private fun entry(
        name: String,
        jar: JarOutputStream,
        write: () -> Unit,
    ) {
        // A fixed time: the same classes make the same jar.
        jar.putNextEntry(JarEntry(name).apply { time = 0 })
        write()
        jar.closeEntry()
    }

    /**
     * The libraries that a submission is compiled against and runs with: Kotlin's, LWJGL with its natives for this machine, JOML.
     * They are those of this program's own class path.
     */
    public fun libraries(): List<Path> =
        System
            .getProperty("java.class.path")
            .split(File.pathSeparator)
            .filter { entry -> LIBRARY.matches(File(entry).name) && isForThisMachine(File(entry).name) }
            .map { Path.of(it).toAbsolutePath().normalize() }

    /** The class path of a run as far as it is ours, given the jar [worker]. */
    public fun own(worker: Path): List<Path> = listOf(worker) + libraries()

    /** The command that runs a submission; see [WorkerRun]. */
    public fun command(run: WorkerRun): List<String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val classPath = own(run.worker).joinToString(File.pathSeparator)
        return listOf(java) + FLAGS + run.options + "-Xmx${run.heapMegabytes}m" +
            listOf("-cp", classPath, MAIN, run.main, run.capture.toString()) + run.classes.map { it.toString() }
    }

    /**
     * What the worker's environment must hold: software rendering, no more OpenGL than the course's, and GLSL of any version: drivers give
     * that to who asks for OpenGL 3.3.
     */
    public val environment: Map<String, String> =
        mapOf("LIBGL_ALWAYS_SOFTWARE" to "1", "MESA_GL_VERSION_OVERRIDE" to "3.3", "MESA_GLSL_VERSION_OVERRIDE" to "460")

    private fun isForThisMachine(name: String): Boolean {
        val natives = Regex("-natives-([\\w-]+)\\.jar").find(name)?.groupValues?.get(1) ?: return true
        val system = System.getProperty("os.name").lowercase()
        val platform = listOf("linux", "mac", "windows").firstOrNull { it in system }
        val suffix = if (System.getProperty("os.arch") in setOf("aarch64", "arm64")) "-arm64" else ""
        return natives == (if (platform == "mac") "macos" else platform) + suffix
    }

    /** Folders of classes, each with a class that lies where they do. */
    private val PARTS = mapOf(
        "cga/grading/capture" to WorkerFiles::class.java,
        "cga/grading/worker" to WorkerFiles::class.java,
        "cga/coach/calls" to Interception::class.java,
    )
    private const val SOUND = "cga.grading.worker.SilentSound"
    private const val MAIN = "cga.grading.worker.WorkerMain"
    private val LIBRARY = Regex("(kotlin-stdlib|annotations|lwjgl|joml)(-.*)?\\.jar")

    /** What every worker's JVM is started with. */
    public val FLAGS: List<String> =
        listOf(
            // A short run: no time for the optimising compiler, one thread for the collector.
            "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC",
            "-Xshare:auto",
            "-Xms128m",
            "-Djava.awt.headless=true",
            // LWJGL's classes for JDK 25 take upcalls another way, which Interception does not know.
            "-Djdk.util.jar.enableMultiRelease=false",
        ) + if (Runtime.version().feature() < NATIVE_ACCESS) emptyList() else listOf("--enable-native-access=ALL-UNNAMED")

    private const val NATIVE_ACCESS = 22
}

/**
 * One run of a submission.
 *
 * @param classes where its compiled classes are, stand-in included: folders or jars, after ours.
 * @param worker the jar that [WorkerFiles.writeJar] wrote.
 * @param main the class with its `main`.
 * @param capture the file to be written. The process is to be started in the folder that holds the submission's `assets`.
 * @param options more options for the JVM.
 */
public class WorkerRun(
    public val classes: List<Path>,
    public val worker: Path,
    public val main: String,
    public val capture: Path,
    public val options: List<String> = emptyList(),
    public val heapMegabytes: Int = 1024,
)
