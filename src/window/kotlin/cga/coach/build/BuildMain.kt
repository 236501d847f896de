package cga.coach.build

import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteRecursively
import kotlin.io.path.extension
import kotlin.io.path.fileSize
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.moveTo
import kotlin.io.path.readLines
import kotlin.io.path.writeLines
import kotlin.system.exitProcess

/**
 * What `./cga run` starts in an exercise's folder: a Kotlin compiler that stays warm beside the window, and compiles whenever a source is
 * saved. It says in a status file what came of it: first the folder of the newest classes, empty while there are none, then what the compiler
 * has against the sources as they are.
 *
 * Arguments: the folder to work in, and the class path of the program. The compiler is on the class path of this process, and is found by its
 * name.
 */
public object BuildMain {
    @JvmStatic
    public fun main(arguments: Array<String>) {
        val (folder, libraries) = arguments
        val build = Build(Path.of("src/main/kotlin"), Path.of(folder).createDirectories(), libraries)
        val window = build.startWindow()
        build.watch(window)
        // The compiler leaves threads behind.
        exitProcess(window.exitValue())
    }
}

/**
 * The sources below [sources], compiled against [libraries] into folders in [folder], each time into another one: the window may be reading
 * the last.
 */
internal class Build(
    private val sources: Path,
    private val folder: Path,
    private val libraries: String,
) {
    private val status = folder.resolve("classes.status")
    private var number = 0
    private var newest = ""

    init {
        write(emptyList())
    }

    fun startWindow(): Process {
        val java = Path.of(System.getProperty("java.home"), "bin", "java")
        val jdk = Runtime.version().feature()
        val options =
            buildList {
                add("-Dcga.status=$status")
                add("-Dcga.main=${mainClass()}")
                System.getProperty("cga.lang")?.let { add("-Dcga.lang=$it") }
                // LWJGL's classes for JDK 25 take upcalls another way.
                add("-Djdk.util.jar.enableMultiRelease=false")
                if (jdk >= NATIVE_ACCESS) add("--enable-native-access=ALL-UNNAMED")
                if (jdk > NATIVE_ACCESS) add("--sun-misc-unsafe-memory-access=allow")
                if (System.getProperty("os.name").startsWith("Mac")) add("-XstartOnFirstThread")
            }
        return ProcessBuilder(listOf("$java") + options + listOf("-cp", libraries, "cga.coach.Coach")).inheritIO().start()
    }

    /** The file with a `main` that makes a game, as a class. */
    private fun mainClass(): String {
        val isMain = { file: Path -> file.readLines().any { it.startsWith("fun main(") } }
        val file = kotlinFiles().firstOrNull(isMain) ?: sources.resolve("cga/exercise/Main.kt")
        val packageName = sources.relativize(file.parent).joinToString(".")
        return "$packageName.${file.fileName.toString().removeSuffix(".kt")}Kt".removePrefix(".")
    }

    /** Compiles whenever something is saved, until [window] ends. */
    fun watch(window: Process) {
        var known = ""
        while (window.isAlive) {
            val now = fingerprint()
            if (now != known) {
                known = now
                compile()
            }
            Thread.sleep(PAUSE_MILLIS)
        }
    }

    private fun compile() {
        val classes = folder.resolve("classes-${++number}").toAbsolutePath()
        val start = System.nanoTime()
        val log = ByteArrayOutputStream()
        val exit = PrintStream(log, true, Charsets.UTF_8).use { run(it, classes) }
        val messages = log.toString(Charsets.UTF_8).lines().filter(String::isNotBlank)
        if (exit == "OK") {
            delete(number - KEPT)
            newest = "$classes"
            write(emptyList())
            if (System.getProperty("cga.timing") != null) System.err.println("compiled in ${(System.nanoTime() - start) / 1_000_000} ms")
        } else {
            write(messages.ifEmpty { listOf("the compiler ended with $exit") })
        }
    }

    private fun run(
        log: PrintStream,
        classes: Path,
    ): String {
        val arguments =
            listOf("-no-stdlib", "-no-reflect", "-nowarn", "-jvm-target", "17", "-module-name", "exercise") +
                listOf("-cp", libraries, "-d", "$classes") + kotlinFiles().map { "$it" }
        val compiler = Class.forName("org.jetbrains.kotlin.cli.jvm.K2JVMCompiler")
        val exec = compiler.getMethod("exec", PrintStream::class.java, Array<String>::class.java)
        return "${exec.invoke(compiler.getConstructor().newInstance(), log, arguments.toTypedArray())}"
    }

    /** Whole or not at all: the window looks at it all the time. */
    private fun write(complaint: List<String>) {
        val part = folder.resolve("classes.part").apply { writeLines(listOf(newest) + complaint) }
        part.moveTo(status, overwrite = true)
    }

    private fun fingerprint() = kotlinFiles().joinToString("\n") { "$it ${it.fileSize()} ${it.getLastModifiedTime()}" }

    private fun kotlinFiles(): List<Path> = Files.walk(sources).use { paths -> paths.filter { it.extension == "kt" }.sorted().toList() }

    @OptIn(ExperimentalPathApi::class)
    private fun delete(number: Int) {
        folder.resolve("classes-$number").deleteRecursively()
    }

    private companion object {
        const val PAUSE_MILLIS = 100L

        /** Folders of classes that stay: the window may read the newest but one. */
        const val KEPT = 2
        const val NATIVE_ACCESS = 22
    }
}
