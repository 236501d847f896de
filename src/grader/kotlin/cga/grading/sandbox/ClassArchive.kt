package cga.grading.sandbox

import cga.framework.AtomicFile
import cga.framework.InputError
import java.io.File
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import java.util.jar.JarFile
import kotlin.io.path.copyTo
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.fileSize
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readLines
import kotlin.io.path.writeLines

/**
 * Classes of our own, parsed and verified once for this JDK, which a job maps instead of loading them: a start costs a second less.
 *
 * What a submission wrote never goes into one. A job whose class path begins with [classPath] may use it.
 *
 * @param file the archive, null where none could be made: jobs then start without.
 */
internal class ClassArchive private constructor(
    val file: Path?,
) {
    /** Options for the JVM; a JVM that cannot use the archive goes on without, and says nothing among the job's own output. */
    val options: List<String> = file?.let { listOf("-XX:SharedArchiveFile=$it", "-Xlog:disable", "-Xlog:all=off") }.orEmpty()

    companion object {
        private const val SECONDS_TO_MAKE = 60L
        private val JAVA = "${Path.of(System.getProperty("java.home"), "bin", "java")}"

        /** What the JDK itself would have in its own archive, which ours takes the place of. */
        private val JDK_CLASSES = Path.of(System.getProperty("java.home"), "lib", "classlist")

        /** No archive at all. */
        val NONE = ClassArchive(null)

        /**
         * The archive [name] in [folder], made where it is not there or not of these jars.
         *
         * @param prefixes names that begin so are archived too where a jar has them, such as `org/joml/`.
         * @param rehearsals each the arguments of a JVM that loads what the jobs load, after [options] and the class path. What they write
         * is to go into the folder that they are given.
         */
        fun of(
            folder: Path,
            name: String,
            classPath: List<Path>,
            options: List<String>,
            prefixes: List<String>,
            rehearsals: List<(Path) -> List<String>>,
        ): ClassArchive {
            val jars = state(classPath) ?: return NONE
            val state = jars + options + prefixes + System.getProperty("java.vm.version")
            val file = folder.resolve("$name-${Integer.toHexString(state.hashCode())}.jsa")
            val path = listOf("-cp", classPath.joinToString(File.pathSeparator))
            if (!file.exists()) make(file, name, path, options, named(classPath, prefixes), rehearsals)
            return ClassArchive(file.takeIf { it.exists() })
        }

        /** What tells the jars of [classPath] from others. Null where one is a folder: the JVM archives none, and they change while one works. */
        fun state(classPath: List<Path>): List<String>? =
            classPath.takeIf { it.all { jar -> jar.isRegularFile() } }?.map { "$it ${it.fileSize()} ${it.getLastModifiedTime()}" }

        private fun make(
            file: Path,
            name: String,
            classPath: List<String>,
            options: List<String>,
            more: List<String>,
            rehearsals: List<(Path) -> List<String>>,
        ) {
            val folder = Temporary.folder("archive")
            try {
                val list = folder.resolve("classes")
                val made = folder.resolve("made.jsa")
                val quiet = options + listOf("-Xlog:disable", "-Xlog:all=off")
                val loaded = rehearsals.flatMapIndexed { index, rehearsal ->
                    val part = folder.resolve("classes-$index")
                    run(quiet + "-XX:DumpLoadedClassList=$part" + classPath + rehearsal(folder))
                    if (part.exists()) part.readLines() else emptyList()
                }
                if (loaded.isEmpty()) return
                val standard = if (JDK_CLASSES.exists()) JDK_CLASSES.readLines() else emptyList()
                list.writeLines(loaded + standard.filterNot { it.startsWith("#") } + more)
                run(quiet + listOf("-Xshare:dump", "-XX:SharedClassListFile=$list", "-XX:SharedArchiveFile=$made") + classPath)
                if (!made.exists()) return
                file.parent.listDirectoryEntries("$name-*.jsa").forEach { it.deleteIfExists() }
                // Others may be making it too: whoever is last replaces it with the same.
                AtomicFile.write(file) { made.copyTo(it, overwrite = true) }
            } catch (_: IOException) {
                // Every start is a little slower.
            } catch (_: InputError) {
                // Likewise.
            } finally {
                Scratch.delete(folder)
            }
        }

        private fun run(arguments: List<String>) {
            val builder = ProcessBuilder(listOf(JAVA) + arguments)
            builder.environment() += JavaCommand.MESA
            val process = builder.redirectError(ProcessBuilder.Redirect.DISCARD).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
            if (!process.waitFor(SECONDS_TO_MAKE, SECONDS)) process.destroyForcibly()
        }

        private fun named(
            jars: List<Path>,
            prefixes: List<String>,
        ): List<String> =
            jars.flatMap { jar ->
                JarFile(jar.toFile()).use { file ->
                    file
                        .stream()
                        .map { it.name }
                        // In a list of classes a name ends at a blank; those of tests have some.
                        .filter { name -> name.endsWith(".class") && ' ' !in name && prefixes.any(name::startsWith) }
                        .map { it.removeSuffix(".class") }
                        .toList()
                }
            }
    }
}
