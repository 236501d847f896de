package cga.grading.worker

import cga.framework.GameWindow
import cga.grading.capture.Capture
import cga.grading.capture.CaptureFile
import cga.grading.capture.WorkerFiles
import cga.grading.capture.WorkerRun
import cga.grading.corpus.Compiled
import cga.grading.submission.StandIn
import cga.testing.projectRoot
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.copyToRecursively
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.createTempDirectory
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** A submission that has run in a worker: what it left and said. */
internal class WorkerProcess(
    val exitCode: Int,
    val out: String,
    val err: String,
    val file: Path,
) {
    /** The capture, read as the grader reads it. */
    val capture: Capture by lazy { CaptureFile.read(file) }

    override fun toString() = "exit code $exitCode\nstdout: $out\nstderr: $err"

    companion object {
        private const val LIMIT_SECONDS = 120L
        private val folder: Path by lazy {
            createTempDirectory("cga-worker").also { Runtime.getRuntime().addShutdownHook(Thread { it.toFile().deleteRecursively() }) }
        }
        private val jar by lazy { folder.resolve("worker.jar").also(WorkerFiles::writeJar) }

        /** This project's own framework and exercise and the test's students, but with the stand-in's window, as one submission. */
        private val submission: List<Path> by lazy {
            val original = projectRoot.toPath().resolve("src/scene/kotlin/cga/framework/GameWindow.kt").readText()
            val own = folder.resolve("own")
            copyClasses(GameWindow::class.java, own, "cga/framework", "cga/exercise")
            copyClasses(WorkerProcess::class.java, own, "cga/grading/worker/students")
            // With the window's own class out of the way, as in a submission whose file was replaced.
            Files.list(own.resolve("cga/framework")).use { list ->
                list.filter { it.fileName.toString().matches(Regex("GameWindow(\\$.*)?\\.class")) }.forEach(Files::delete)
            }
            listOf(compile(mapOf("GameWindow.kt" to StandIn(original).source()), listOf(own)), own)
        }

        /** Runs the student's program [main], an object of [cga.grading.worker.students], in the project's folder. */
        fun ofStudent(
            main: String,
            environment: Map<String, String> = emptyMap(),
        ): WorkerProcess = run(submission, "cga.grading.worker.students.$main", environment)

        /** Compiles [sources] (name → text) as a submission's compiler would, and answers the folder of the classes. */
        fun compile(
            sources: Map<String, String>,
            classPath: List<Path> = emptyList(),
        ): Path {
            val place = Files.createTempDirectory(folder, "compile")
            for ((name, text) in sources) place.resolve("src/$name").also { it.parent.createDirectories() }.writeText(text)
            val classes = place.resolve("classes")
            // ktlint's own compiler, older than ours: so the case of a submission that names an old one is tried as well.
            val complaints = Compiled.complaints(listOf(place.resolve("src")), classes, classPath + listOf(jar))
            check(complaints.isEmpty()) { "the submission does not compile: $complaints" }
            return classes
        }

        /** Runs the class [main] of [classes]. */
        fun run(
            classes: List<Path>,
            main: String,
            environment: Map<String, String> = emptyMap(),
        ): WorkerProcess {
            val file = Files.createTempDirectory(folder, "run").resolve("capture")
            val command = WorkerFiles.command(WorkerRun(classes, jar, main, file))
            return execute(command, projectRoot.toPath(), WorkerFiles.environment + environment, file)
        }

        private fun execute(
            command: List<String>,
            directory: Path,
            environment: Map<String, String>,
            file: Path,
        ): WorkerProcess {
            val logs = Files.createTempDirectory(folder, "logs")
            val out = logs.resolve("out")
            val err = logs.resolve("err")
            val builder = ProcessBuilder(command).directory(directory.toFile()).redirectOutput(out.toFile()).redirectError(err.toFile())
            builder.environment() += environment
            val process = builder.start()
            process.outputStream.close()
            if (!process.waitFor(LIMIT_SECONDS, SECONDS)) {
                process.destroyForcibly().waitFor()
                error("still running after $LIMIT_SECONDS s: $command\nstdout: ${out.readText()}\nstderr: ${err.readText()}")
            }
            return WorkerProcess(process.exitValue(), out.readText(), err.readText(), file)
        }

        private fun copyClasses(
            sample: Class<*>,
            target: Path,
            vararg packages: String,
        ) {
            val home = Path.of(sample.protectionDomain.codeSource.location.toURI())
            if (Files.isDirectory(home)) return copyClasses(home, target, packages)
            FileSystems.newFileSystem(home).use { copyClasses(it.getPath("/"), target, packages) }
        }

        @OptIn(ExperimentalPathApi::class)
        private fun copyClasses(
            home: Path,
            target: Path,
            packages: Array<out String>,
        ) {
            for (name in packages) {
                check(home.resolve(name).exists()) { "$name is not in $home" }
                home.resolve(name).copyToRecursively(target.resolve(name).also { it.createParentDirectories() }, followLinks = false)
            }
        }
    }
}
