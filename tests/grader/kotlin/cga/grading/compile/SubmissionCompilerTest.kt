package cga.grading.compile

import cga.grading.sandbox.Hostile
import cga.grading.sandbox.JavaCommand
import cga.grading.sandbox.Job
import cga.grading.sandbox.Scratch
import cga.grading.submission.MadeUp
import cga.testing.Slow
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempDirectory

/** With the real compiler in the real sandbox. */
@Slow
class SubmissionCompilerTest {
    private val folder = createTempDirectory("compile")
    private val sandbox = Hostile.confined()

    /** What this JVM itself runs with. */
    private val libraries = System.getProperty("java.class.path").split(':').map(Path::of).filter { "${it.fileName}".startsWith("joml") }

    @AfterEach
    fun close() = Scratch.delete(folder)

    private fun compile(files: Map<String, String>, cache: CompilerCache = CACHE, window: String = MadeUp.WINDOW): CompileResult {
        val tree = MadeUp.prepare(folder, files, window)
        return SubmissionCompiler(sandbox, cache, libraries).compile(tree, tree.files(), folder.resolve("scratch").createDirectories())
    }

    /** What the compiled submission prints. */
    private fun run(result: CompileResult, mainClass: String): String {
        val classes = result.classes ?: error("${result.errors}")
        val classPath = classes + result.runtime + libraries
        val outcome = sandbox.run(
            Job(JavaCommand(classPath, mainClass).command(), folder.resolve("run").createDirectories(), readOnly = classPath),
        )
        assertTrue(outcome.isSuccess) { outcome.errors }
        return outcome.output
    }

    @Test
    fun `a submission compiles with the newest compiler, with our window in place of its own, and runs`() {
        val standIn = "package cga.framework\nopen class GameWindow(val width: Int, val height: Int) { fun run() { println(\"ours\") } }\n"
        val greet = "public static String greet() { return new cga.exercise.Kt().name() + \"!\"; }"
        val java = "package cga.exercise.util;\npublic class Greeter { $greet }\n"
        val kotlin = "package cga.exercise\nclass Kt { fun name() = \"mixed\"\n fun back() = cga.exercise.util.Greeter.greet() }\n"
        val body = "    println(org.joml.Vector3f(1f).x)\n    println(Kt().back())\n    Game().run()\n"
        val main = "package cga.exercise\nimport cga.exercise.game.Game\nfun main() {\n$body}\n"
        val files = MadeUp.FILES + mapOf(
            "src/main/kotlin/cga/exercise/Main.kt" to main,
            "src/main/java/cga/exercise/util/Greeter.java" to java,
            "src/main/kotlin/cga/exercise/Kt.kt" to kotlin,
        )
        val result = compile(files, window = standIn)
        assertEquals(emptyList<CompileError>(), result.errors)
        assertEquals("Kotlin ${CompilerCache.NEWEST}, language level ${CompilerCache.LOWEST_LEVEL}", result.compiler)
        assertEquals(emptyList<String>(), result.notes)
        assertEquals("1.0\nmixed!\nours\n", run(result, "cga.exercise.MainKt"))
    }

    @Test
    fun `errors name the file as the student does, with the line`() {
        val broken = MadeUp.SCENE.replace("println(\"\$dt \$t\")", "val x: Int = \"text\"; missing()")
        val build = "build.gradle" to "plugins { id 'org.jetbrains.kotlin.jvm' version '${CompilerCache.NEWEST}' }"
        val result = compile(MadeUp.FILES + ("src/main/kotlin/cga/exercise/game/Scene.kt" to broken) + build)
        assertEquals(null, result.classes)
        assertEquals(
            setOf("src/main/kotlin/cga/exercise/game/Scene.kt" to 3),
            result.errors
                .map {
                    it.file to it.line
                }.toSet(),
        ) { "${result.errors}" }
        assertTrue(result.errors.any { "missing" in it.message }) { "${result.errors}" }
    }

    @Test
    fun `an error in Java is one too`() {
        val build = "build.gradle" to "plugins { id 'org.jetbrains.kotlin.jvm' version '${CompilerCache.NEWEST}' }"
        val java = "src/main/java/cga/exercise/Bad.java" to "package cga.exercise;\nclass Bad { int x = \"text\"; }\n"
        val result = compile(MadeUp.FILES + java + build)
        assertEquals(listOf("src/main/java/cga/exercise/Bad.java" to 2), result.errors.map { it.file to it.line })
    }

    @Test
    fun `without the named compiler the newest one's errors stand, and the reason is told`() {
        val broken = "src/main/kotlin/cga/exercise/game/Scene.kt" to MadeUp.SCENE.replace("println(", "missing(")
        val files = MadeUp.FILES + broken + ("build.gradle" to "kotlin_version = '99.0.1'")
        val result = compile(files, CompilerCache(CACHE_FOLDER, Repository(folder.resolve("repository"), null)))
        assertEquals(listOf(3), result.errors.map { it.line })
        assertTrue(result.notes.any { "No other compiler could be tried" in it && "offline" in it }) { "${result.notes}" }
    }

    private companion object {
        /** Kept from test to test; the newest compiler is one of this project's own test dependencies. */
        val CACHE_FOLDER: Path = Path.of("build/compilers").toAbsolutePath()
        val CACHE = CompilerCache(CACHE_FOLDER)
    }
}
