package cga.testing

import java.io.File.pathSeparator
import java.lang.ProcessBuilder.Redirect.DISCARD
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.fileSize
import kotlin.io.path.listDirectoryEntries

/** The classes that a small render loads, parsed and verified once, as the launcher does it: the tests start hundreds of processes. */
internal object ProgramArchive {
    private const val SECONDS_TO_MAKE = 60L

    /** The option that maps the archive of [classPath], none where it could not be made. [java] is the command up to the class path. */
    @Synchronized
    fun options(java: List<String>, classPath: String): List<String> = made.getOrPut(classPath) { make(java, classPath) }

    private val made = HashMap<String, List<String>>()

    private fun make(java: List<String>, classPath: String): List<String> {
        // The parts below the command line have no program to start.
        if (runCatching { Class.forName("cga.cli.MainKt", false, javaClass.classLoader) }.isFailure) return emptyList()
        val state = java + classPath.split(pathSeparator).map { "$it ${Path.of(it).fileSize()}" } + System.getProperty("java.vm.version")
        val folder = testingFolder.createDirectories()
        val archive = folder.resolve("program-%08x.jsa".format(state.hashCode()))
        // One JVM makes it, and the others wait.
        FileChannel.open(folder.resolve("program.lock"), CREATE, WRITE).use { channel ->
            channel.lock().use { if (!archive.exists()) make(archive, java, classPath) }
        }
        return if (archive.exists()) listOf("-XX:SharedArchiveFile=$archive") else emptyList()
    }

    private fun make(archive: Path, java: List<String>, classPath: String) {
        val folder = createTempDirectory(archive.parent, "archive")
        try {
            val (classes, part) = listOf("classes", "made").map(folder::resolve)
            val render = listOf("cga.cli.MainKt", "render", "--size", "16x9", "--out", "${folder.resolve("picture.png")}")
            run(java + listOf("-XX:DumpLoadedClassList=$classes", "-cp", classPath) + render)
            run(java + listOf("-Xshare:dump", "-XX:SharedClassListFile=$classes", "-XX:SharedArchiveFile=$part", "-cp", classPath))
            // One for each part's class path; those of other days go.
            archive.parent.listDirectoryEntries("program-*.jsa").filter(::isOld).forEach { it.deleteIfExists() }
            if (part.exists()) Files.move(part, archive)
        } finally {
            folder.toFile().deleteRecursively()
        }
    }

    private fun isOld(file: Path) = file.toFile().lastModified() < System.currentTimeMillis() - SECONDS.toMillis(24 * 3600)

    private fun run(command: List<String>) {
        val process = ProcessBuilder(command).redirectOutput(DISCARD).redirectError(DISCARD).start()
        if (!process.waitFor(SECONDS_TO_MAKE, SECONDS)) process.destroyForcibly().waitFor()
    }
}
