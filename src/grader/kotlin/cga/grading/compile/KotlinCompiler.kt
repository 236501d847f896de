package cga.grading.compile

import cga.framework.AtomicFile
import cga.framework.InputError
import cga.grading.sandbox.JavaCommand
import cga.grading.sandbox.Scratch
import cga.grading.sandbox.Temporary
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.writeText

/**
 * A Kotlin compiler that runs as a process.
 *
 * @param jars the compiler itself.
 * @param stdlib the standard library of its own version, which it can read.
 * @param languageLevel as `-language-version` wants it, null for the compiler's own.
 */
public class KotlinCompiler internal constructor(
    public val version: String,
    public val jars: List<Path>,
    public val stdlib: Path,
    public val languageLevel: String?,
    private val archive: Path?,
) {
    /** Compilers older than 1.5 reach into the JDK; for others it only makes every start slower. */
    private val opened: List<String> get() = if (number < CLOSED) OPENED else emptyList()

    private val number = version.split('.').map { it.toInt() }.let { it[0] * 1000 + it[1] }

    /** Measured: 1.9.25 reads a library of Kotlin 2.3 when told to, 1.6.21 does not whatever it is told. */
    internal val readsAnyMetadata: Boolean get() = number >= READS_AHEAD

    /** How reports name it. */
    public val title: String = "Kotlin $version" + languageLevel?.let { ", language level $it" }.orEmpty()

    /** What the command must be able to read. */
    internal val readable: List<Path> get() = jars + listOf(stdlib) + listOfNotNull(archive?.takeIf { it.exists() })

    /**
     * The command that starts [service], a class in [own], with this compiler beside it; its arguments are [folder] and the compiler's name.
     */
    internal fun serviceCommand(own: List<Path>, service: String, folder: Path): List<String> =
        JavaCommand(jars + own, service, listOf("$folder", MAIN), HEAP_MEGABYTES, options() + KEEP_ALIVE).command()

    /** The command that compiles all below [sources] against [libraries] to [classes]. */
    internal fun command(sources: List<Path>, libraries: List<Path>, classes: Path): List<String> =
        java(arguments(sources, libraries, classes), options())

    private fun java(arguments: List<String>, options: List<String>) = JavaCommand(jars, MAIN, arguments, HEAP_MEGABYTES, options).command()

    private fun options(archiving: List<String> = listOfNotNull(archive?.takeIf { it.exists() }?.let { "-XX:SharedArchiveFile=$it" })) =
        SILENT + INLINE_LITTLE + opened + archiving

    /** The compiler's own arguments: [sources] and [classes] are folders, [classes] may be a jar to be written. */
    internal fun arguments(sources: List<Path>, libraries: List<Path>, classes: Path): List<String> {
        val target = if (number >= KNOWS_17) "17" else "1.8"
        val level = languageLevel?.let { listOf("-language-version", it, "-api-version", it, NO_AGE) } ?: listOf(ANY_METADATA)
        return listOf("-no-stdlib", "-no-reflect", "-nowarn", "-module-name", "submission", "-jvm-target", target) + level +
            listOf("-cp", (listOf(stdlib) + libraries).joinToString(":"), "-d", "$classes") + sources.map { "$it" }
    }

    /** Makes the archive of the compiler's classes, with which it starts in half the time, unless it is there. */
    internal fun warmUp() {
        if (archive == null || archive.exists()) return
        archive.parent.createDirectories()
        val folder = Temporary.folder("warm-up")
        try {
            val source = folder.resolve("A.kt").apply { writeText(WARM_UP) }
            val made = folder.resolve("made.jsa")
            val process = ProcessBuilder(
                java(arguments(listOf(source), emptyList(), folder.resolve("classes")), options(listOf("-XX:ArchiveClassesAtExit=$made"))),
            ).redirectErrorStream(true)
                .redirectOutput(folder.resolve("log").toFile())
                .start()
            if (!process.waitFor(WARM_UP_SECONDS, SECONDS)) process.destroyForcibly().waitFor()
            // Others may be making it too: whoever is last replaces it with the same.
            if (process.exitValue() == 0 && made.exists()) AtomicFile.write(archive) { made.copyTo(it, overwrite = true) }
        } catch (e: IOException) {
            throw InputError("the compiler's class archive cannot be made in ${archive.parent} (${e.message}): is the folder writable?", e)
        } finally {
            Scratch.delete(folder)
        }
    }

    private companion object {
        const val MAIN = "org.jetbrains.kotlin.cli.jvm.K2JVMCompiler"

        /** Measured: the course's own 3300 lines need 400 MB in all; less makes it slower. */
        const val HEAP_MEGABYTES = 512
        const val NO_AGE = "-Xsuppress-version-warnings"
        const val ANY_METADATA = "-Xskip-metadata-version-check"

        /** Kotlin 1.6 was the first to write Java 17's class files. */
        const val KNOWS_17 = 1006
        const val CLOSED = 1005
        const val READS_AHEAD = 1009
        const val WARM_UP_SECONDS = 120L
        val SILENT = listOf("-Xlog:disable", "-Xlog:all=off", "-Dkotlin.colors.enabled=false")

        /** Half of a compiler's short life goes into compiling itself. Measured: with less inlining it takes 5.8 s of the processor, not 7.0. */
        const val INLINE_LITTLE = "-XX:C1MaxInlineSize=10"

        /** What the compiler knows of libraries stays from one request to the next. */
        const val KEEP_ALIVE = "-Dkotlin.environment.keepalive=true"

        val OPENED = listOf("java.lang", "java.util", "java.io", "java.util.concurrent.atomic").flatMap {
            listOf("--add-opens", "java.base/$it=ALL-UNNAMED")
        }
        val WARM_UP =
            """
            package a
            open class A(val x: Float, var list: List<String> = listOf("a", "b")) {
                private val map = HashMap<Int, String>()
                val size by lazy { list.map { it.length }.filter { it > 0 }.sum() }
                open fun f(t: Float): String = if (t > x) "${'$'}t" else map[1] ?: error("none")
            }
            interface I { fun g(a: A?): Int = a?.size ?: 0 }
            data class D(val a: Int, val b: Double)
            enum class E { X, Y }
            object B : A(1f), I { override fun f(t: Float) = when (E.valueOf("X")) { E.X -> super.f(t); E.Y -> D(1, 2.0).copy(a = 2).toString() } }
            fun main(args: Array<String>) {
                for (i in 0 until 10 step 2) try { println(B.f(i.toFloat()) + Math.sin(1.0)) } catch (e: Exception) { e.printStackTrace() }
            }
            """.trimIndent()
    }
}
