package cga.grading.pipeline

import cga.grading.corpus.Corpus
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * The corpus' base project, which does in addition what the first line of its `assets/behaviour.txt` says; the other lines are arguments.
 * The Kotlin is always the same, so that it has to be compiled only once.
 */
internal object HostileProject {
    /** Writes one that behaves as [behaviour] says into [folder]. */
    fun write(
        folder: Path,
        behaviour: String,
        arguments: List<String> = emptyList(),
    ): Path {
        Corpus.materialize(Corpus.byName("plain"), folder)
        folder.resolve("assets/behaviour.txt").writeText((listOf(behaviour) + arguments).joinToString("\n"))
        val exercise = folder.resolve("src/main/kotlin/cga/exercise")
        exercise.resolve("Behaviour.kt").writeText(BEHAVIOUR)
        edit(exercise.resolve("Main.kt"), "fun main() {", "fun main() {\n    Behaviour.atStart()")
        edit(
            exercise.resolve("game/Scene.kt"),
            "fun render(dt: Float, t: Float) {",
            "fun render(dt: Float, t: Float) {\n        cga.exercise.Behaviour.atPicture()",
        )
        return folder
    }

    /** Writes one whose fragment shader has [statement] at the beginning of `main`, and [declaration] before it. */
    fun writeShader(
        folder: Path,
        declaration: String,
        statement: String,
    ): Path {
        write(folder, "nothing")
        edit(folder.resolve("assets/shaders/tron_frag.glsl"), "void main() {", "$declaration\nvoid main() {\n    $statement")
        return folder
    }

    private fun edit(
        file: Path,
        old: String,
        new: String,
    ) {
        val text = file.readText()
        check(old in text) { "$file has no longer: $old" }
        file.writeText(text.replace(old, new))
    }

    private val BEHAVIOUR =
        """
        package cga.exercise

        import org.lwjgl.BufferUtils
        import org.lwjgl.opengl.GL33C.*
        import org.lwjgl.system.MemoryUtil
        import java.io.File
        import java.net.ServerSocket
        import java.net.Socket
        import kotlin.system.exitProcess

        object Behaviour {
            private val lines = File("assets/behaviour.txt").readLines()
            private val behaviour = lines.first()
            private val arguments = lines.drop(1)
            private val home = File(System.getenv("HOME"))
            private var pictures = 0

            fun atStart() {
                when (behaviour) {
                    "endless loop" -> while (true) Thread.onSpinWait()
                    "exit" -> exitProcess(arguments[0].toInt())
                    "halt" -> Runtime.getRuntime().halt(arguments[0].toInt())
                    "crash" -> MemoryUtil.memPutInt(0L, 1)
                    "throw" -> throw IllegalStateException(arguments[0])
                    "fork bomb" -> ProcessBuilder("sh", "-c", "f() { f | f & sleep 60; }; f").start().waitFor()
                    "threads" -> while (true) Thread { Thread.sleep(60_000) }.start()
                    "output" -> while (true) println("x".repeat(1_000_000))
                    "disk" -> File(home, "large").outputStream().use { out -> repeat(10_000) { out.write(ByteArray(1 shl 20)) } }
                    "memory" -> generateSequence { MemoryUtil.nmemCalloc(1, 64L shl 20) }.forEach { MemoryUtil.memSet(it, 1, 64L shl 20) }
                    "delete" -> (arguments.map(::File) + home + File(".").absoluteFile).forEach { println(it.deleteRecursively()) }
                    "read" -> read()
                    "sockets" -> sockets()
                    "fake capture" -> fake("capture.bin")
                    "fake findings" -> fake("findings.json")
                    "link as capture" -> link()
                    "borrowed capture" -> borrow()
                    "say" -> arguments.forEach(::println)
                }
            }

            fun atPicture() {
                pictures++
                when (behaviour) {
                    "exit amid" -> if (pictures == 3) exitProcess(0)
                    "throw amid" -> if (pictures == 3) throw IllegalStateException("the third picture")
                    "texture" -> texture()
                    "many programs" -> repeat(2000) { glCreateProgram() }
                }
            }

            private fun read() {
                for (name in arguments) println(runCatching { File(name).readText() }.getOrElse { "cannot read it" })
                File("/").walk().maxDepth(3).onEnter { it.name !in setOf("proc", "sys", "usr") }.forEach { println(it) }
            }

            private fun sockets() {
                println(runCatching { Socket("127.0.0.1", arguments[0].toInt()).getOutputStream().write(1) })
                println(runCatching { ServerSocket(0) })
            }

            // The worker's own file and all around it, and then no word to the worker any more.
            private fun fake(name: String) {
                for (folder in listOf(home, home.parentFile, File("."))) runCatching { File(folder, name).writeText(arguments.joinToString("\n")) }
                Runtime.getRuntime().halt(0)
            }

            private fun link() {
                java.nio.file.Files.createSymbolicLink(File(home, "capture.bin").toPath(), java.nio.file.Path.of(arguments[0]))
                Runtime.getRuntime().halt(0)
            }

            private fun borrow() {
                File("assets/capture.bin").copyTo(File(home, "capture.bin"), overwrite = true)
                Runtime.getRuntime().halt(0)
            }

            private fun texture() {
                val name = glGenTextures()
                glBindTexture(GL_TEXTURE_2D, name)
                glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 32768, 32768, 0, GL_RGBA, GL_UNSIGNED_BYTE, 0L)
                println(runCatching { BufferUtils.createByteBuffer(32768 * 32768 * 4).capacity() })
                glBindTexture(GL_TEXTURE_2D, 0)
            }
        }
        """.trimIndent()
}
