package cga.grading.compile

import cga.grading.sandbox.End
import cga.grading.sandbox.Hostile
import cga.grading.sandbox.Job
import cga.grading.sandbox.Outcome
import cga.grading.sandbox.Sandbox
import cga.grading.sandbox.Scratch
import cga.grading.submission.MadeUp
import cga.testing.Slow
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.io.File
import java.nio.file.Path
import java.util.zip.ZipFile
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.createTempDirectory
import kotlin.io.path.exists
import kotlin.io.path.writeText

/** With the real compiler in the real sandbox, but where the compiler itself is played by somebody who lies. */
@Slow
class SharedCompilerTest {
    private val folder = createTempDirectory("shared")
    private val compiler = CompilerCache(Path.of("build/compilers").toAbsolutePath()).newest()
    private var folders = 0

    @AfterEach
    fun close() = Scratch.delete(folder)

    private fun shared(sandbox: Sandbox) = SharedCompiler(sandbox, compiler, OWN, emptyList())

    private fun sources(text: String): List<Path> {
        val source = folder.resolve("sources${folders++}/0000").createDirectories().resolve("A.kt")
        return listOf(source.apply { writeText(text) })
    }

    private fun empty() = folder.resolve("classes${folders++}").createDirectories()

    private fun jar() = empty().resolve("classes.jar")

    private fun classes(jar: Path) =
        ZipFile(jar.toFile()).use { zip ->
            zip.entries().asSequence().filter { it.name.endsWith(".class") }.associate { it.name to zip.getInputStream(it).readBytes() }
        }

    @Test
    fun `one after another is compiled by one process, to the classes that a process of its own makes`() {
        val starts = ArrayList<Job>()
        val real = Hostile.confined()
        val counting = Sandbox { job -> real.run(job.also { starts += it }) }
        shared(counting).use { shared ->
            for (text in listOf(FIRST, SECOND)) {
                val sources = sources(text)
                val together = jar()
                assertTrue(shared.compiles(sources, together))
                val alone = empty()
                val job = Job(compiler.command(sources, emptyList(), alone.resolve("a.jar")), alone, compiler.readable + sources)
                assertTrue(real.run(job).isSuccess)
                val (expected, made) = classes(alone.resolve("a.jar")) to classes(together)
                assertEquals(expected.keys, made.keys)
                for ((name, bytes) in expected) assertArrayEquals(bytes, made.getValue(name), name)
            }
        }
        assertEquals(1, starts.size)
    }

    @Test
    fun `sources with errors get no, and the next ones their yes`() {
        shared(Hostile.confined()).use { shared ->
            assertFalse(shared.compiles(sources("class A : Missing()"), jar()))
            assertTrue(shared.isUsable)
            assertTrue(shared.compiles(sources(FIRST), jar()))
        }
    }

    @Test
    fun `sources that break the compiler cost the others nothing`() {
        val deep = "val x = " + "(".repeat(DEPTH) + "1" + ")".repeat(DEPTH)
        val starts = ArrayList<Job>()
        val real = Hostile.confined()
        SharedCompilers { shared(Sandbox { job -> real.run(job.also { starts += it }) }) }.use { compilers ->
            assertFalse(compilers.compiles(sources(deep), jar()))
            assertTrue(compilers.compiles(sources(SECOND), jar()))
        }
        assertEquals(2, starts.size)
        assertTrue(starts.none { it.scratch.exists() }) { "left behind" }
    }

    @Test
    fun `a compiler that does not start says no`() {
        shared { Outcome(End.Exited(1), "", "", 0.0, 0.0, 0) }.use { shared ->
            assertFalse(shared.compiles(sources(FIRST), jar()))
            assertFalse(shared.isUsable)
        }
    }

    @Test
    fun `a link in place of the classes is not followed`() {
        val secret = folder.resolve("secret").apply { writeText("secret") }
        val liar = Sandbox { job ->
            val files = SharedFiles(job.scratch)
            files.ready.writeText("")
            while (!files.request(0).exists()) Thread.sleep(1)
            files.jar(0).createSymbolicLinkPointingTo(secret)
            files.answer(0).writeText("OK")
            Thread.sleep(Long.MAX_VALUE)
            error("never")
        }
        val jar = jar()
        assertFalse(shared(liar).use { it.compiles(sources(FIRST), jar) })
        assertFalse(jar.exists())
    }

    @Test
    fun `a submission is told the same, whether its compiler is shared or not`() {
        val broken = "src/main/kotlin/cga/exercise/game/Scene.kt" to MadeUp.SCENE.replace("println(", "missing(")
        val java = "src/main/java/cga/exercise/J.java" to "package cga.exercise;\npublic class J { public int one() { return 1; } }\n"
        val user = "src/main/kotlin/cga/exercise/K.kt" to "package cga.exercise\nval two = J().one() + 1\n"
        val build = "build.gradle" to "plugins { id 'org.jetbrains.kotlin.jvm' version '${CompilerCache.NEWEST}' }"
        for (files in listOf(MadeUp.FILES + java + user, MadeUp.FILES + broken + build)) {
            val tree = MadeUp.prepare(empty(), files)
            val (alone, shared) = listOf(null, OWN).map { own ->
                val cache = CompilerCache(Path.of("build/compilers").toAbsolutePath())
                SubmissionCompiler(Hostile.confined(), cache, emptyList(), shared = own).use { it.compile(tree, tree.files(), empty()) }
            }
            assertEquals(alone.errors, shared.errors)
            assertEquals(alone.compiler to alone.notes, shared.compiler to shared.notes)
            assertEquals(alone.classes?.first()?.let(::classes)?.keys, shared.classes?.first()?.let(::classes)?.keys)
        }
    }

    private companion object {
        const val FIRST = "package a\nclass A { fun f() = listOf(1, 2).map { it + 1 } }\n"

        /** The same class once more: nothing of the first may be left in the compiler. */
        const val SECOND = "package a\nclass A { fun g(x: Float) = \"\$x\" }\nobject B\n"

        /** Deeper than any stack of a JVM. */
        const val DEPTH = 20_000
        val OWN = System
            .getProperty(
                "java.class.path",
            ).split(File.pathSeparator)
            .map(Path::of)
            .filter { it.exists() }
            .map { it.toRealPath() }
    }
}
