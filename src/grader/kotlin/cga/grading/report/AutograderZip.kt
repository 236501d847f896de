package cga.grading.report

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.grading.prepared.COURSE_PROJECT
import cga.grading.starter.StarterFiles
import java.net.URI
import java.nio.file.FileSystem
import java.nio.file.FileSystems
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.exists
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isDirectory
import kotlin.io.path.isExecutable
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.visitFileTree
import kotlin.io.path.writeBytes

/**
 * What the instructor chose for an autograder.
 *
 * @param edition of the course, null where it is detected.
 * @param rubric the bytes of a rubric file, null for the default.
 * @param unsafeNoSandbox whether submissions run where there is no sandbox; otherwise their results say that they did not.
 */
public class AutograderConfig(
    public val language: Language,
    public val edition: String?,
    public val rubric: ByteArray?,
    public val unsafeNoSandbox: Boolean,
)

/** Writes Gradescope's autograder: `setup.sh`, `run_autograder`, the instructor's choices and the program, built. */
public object AutograderZip {
    private const val NAME = "autograder.zip"

    // setup.sh grades the starter, to have the compiler ready.
    private val PROGRAM =
        listOf("cga", "pom.xml", "build.gradle.kts", "settings.gradle.kts", "gradle.properties", "gradle", "src", "shaders", "assets") +
            listOf(
                COURSE_PROJECT,
                "build/cga/lib",
                "build/cga/libraries",
                "build/cga/grader.stamp",
                "build/cga/grader.classpath",
            ) +
            StarterFiles.COPIES.filterNot { it.startsWith("gradle/") }

    // Gradescope's machines run Linux.
    private val FOREIGN = Regex(""".*natives-(windows|macos).*\.jar""")

    /** Writes the zip into [folder], made from the program in [home], and returns it. Throws [InputError] when that is not possible. */
    public fun write(home: Path, folder: Path, config: AutograderConfig): Path {
        if (!home.resolve("build/cga/lib").isDirectory()) {
            throw InputError(
                "there is no built program in ${home.resolve("build/cga/lib")}: start this command with ./cga, which builds it.",
            )
        }
        if (folder.exists() && !folder.isDirectory()) throw InputError("$folder is a file: name a folder for $NAME.")
        folder.createDirectories()
        val target = folder.resolve(NAME)
        AtomicFile.write(target) { temporary ->
            val options = mapOf("create" to "true", "enablePosixFileAttributes" to "true")
            FileSystems.newFileSystem(URI("jar:${temporary.toAbsolutePath().toUri()}"), options).use { zip -> fill(zip, home, config) }
        }
        return target
    }

    private fun fill(zip: FileSystem, home: Path, config: AutograderConfig) {
        for (script in listOf("setup.sh", "run_autograder")) zip.put(script, resource(script), isExecutable = true)
        zip.put("config.sh", config(config).toByteArray())
        config.rubric?.let { zip.put("rubric.json", it) }
        for (part in PROGRAM.map(home::resolve).filter { it.exists() }) {
            for (file in filesBelow(part)) {
                val name = home.relativize(file).invariantSeparatorsPathString
                if (!FOREIGN.matches(file.name)) zip.put("cga/$name", file.readBytes(), file.isExecutable())
            }
        }
    }

    /** What is not hidden and no backup, as the launcher's fingerprint of the sources has it. */
    private fun filesBelow(part: Path): List<Path> {
        if (part.isRegularFile()) return listOf(part)
        val files = mutableListOf<Path>()
        part.visitFileTree {
            onVisitFile { file, _ ->
                if (file.isRegularFile(NOFOLLOW_LINKS) && !file.name.startsWith(".") && !file.name.endsWith("~")) files.add(file)
                FileVisitResult.CONTINUE
            }
        }
        return files.sorted()
    }

    /** Plain words only: the script reads it as shell. */
    private fun config(config: AutograderConfig): String =
        """
        |# What the instructor chose when this autograder was written. May be edited before the upload.
        |CGA_LANGUAGE=${config.language.code}
        |CGA_EDITION=${config.edition.orEmpty()}
        |# "yes": where the container has no sandbox, submissions run without. They can then read and write all that the autograder can,
        |# its rubric and its results too. Anything else: they do not run there, and their results say so.
        |CGA_UNSAFE_NO_SANDBOX=${if (config.unsafeNoSandbox) "yes" else "no"}
        |
        """.trimMargin()

    private fun FileSystem.put(name: String, content: ByteArray, isExecutable: Boolean = false) {
        val file = getPath("/$name").createParentDirectories()
        file.writeBytes(content)
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(if (isExecutable) "rwxr-xr-x" else "rw-r--r--"))
    }

    private fun resource(name: String): ByteArray =
        checkNotNull(AutograderZip::class.java.getResource("autograder/$name")) { "$name is missing from the program" }.readBytes()
}
