package cga.grading.report

import cga.framework.InputError
import cga.grading.findings.FailureReason
import cga.grading.findings.Outcome
import cga.grading.findings.Refused
import cga.grading.rubric.Rubric
import cga.grading.starter.StarterFiles
import cga.testing.Need
import cga.testing.projectRoot
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermission
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.exists
import kotlin.io.path.isRegularFile
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeText

class AutograderZipTest {
    @TempDir
    lateinit var folder: Path

    private val home get() = folder.resolve("home")
    private val root get() = folder.resolve("autograder")

    /** A home with a program that notes its arguments and does as [script] says. */
    private fun home(script: String = "exit 0") {
        val files =
            mapOf(
                "cga" to "#!/bin/sh\necho \"$@\" >\"$folder/arguments\"\n$script\n",
                "build/cga/lib/cga.jar" to "", "build/cga/lib/lwjgl-natives-linux.jar" to "",
                "build/cga/lib/lwjgl-natives-windows.jar" to "",
                "build/cga/grader.stamp" to "1", "build/cga/grader.classpath" to "a.jar", "build/cga/build.log" to "",
                "src/main/A.kt" to "", "src/.secret" to "", "shaders/a.glsl" to "",
                "tests/A.kt" to "", ".git/config" to "",
            ) + StarterFiles.COPIES.associateWith { "" }
        for ((name, text) in files) home.resolve(name).createParentDirectories().writeText(text)
        home.resolve("cga").toFile().setExecutable(true)
    }

    private fun zip(
        config: AutograderConfig = AutograderConfig(
            Language.GERMAN,
            null,
            null,
            false,
        ),
    ) = AutograderZip.write(home, folder.resolve("zip"), config)

    /** Unpacks [zip] where Gradescope puts it. */
    private fun unpack(zip: Path) {
        FileSystems.newFileSystem(zip, mapOf("enablePosixFileAttributes" to "true")).use { files ->
            for (file in files.getPath("/").walk().filter { it.isRegularFile() }) {
                val target = root.resolve("source").resolve("$file".drop(1)).createParentDirectories()
                file.copyTo(target, overwrite = true)
                Files.setPosixFilePermissions(target, Files.getPosixFilePermissions(file))
            }
        }
    }

    /** Runs [script] of what was unpacked, and returns its exit code and what it said. */
    private fun start(script: String): Pair<Int, String> {
        val log = folder.resolve("log")
        val process = ProcessBuilder("${root.resolve("source/$script")}").redirectErrorStream(true).redirectOutput(log.toFile())
        process.environment()["AUTOGRADER_ROOT"] = "$root"
        process.environment()["PATH"] = "${folder.resolve("bin")}:${System.getenv("PATH")}"
        val started = process.start()
        assertTrue(started.waitFor(30, SECONDS))
        return started.exitValue() to log.readText()
    }

    /** Unpacks [zip], runs it on a submission, and returns results.json. */
    private fun run(zip: Path): String {
        unpack(zip)
        root.resolve("submission").createDirectories()
        val (exitCode, said) = start("run_autograder")
        assertEquals(0, exitCode, said)
        return root.resolve("results/results.json").readText()
    }

    /** Makes the image of a program whose starter comes out as [outcome], which the grader takes for none of its own failures. */
    private fun setUp(outcome: (Path) -> Outcome): Pair<Int, String> {
        for (command in listOf("apt-get", "apt-cache")) {
            val file = folder.resolve("bin/$command").createParentDirectories()
            file.writeText("#!/bin/sh\n")
            file.toFile().setExecutable(true)
        }
        val results = folder.resolve("graded").createDirectories()
        val starter =
            GradedSubmission("starter", results.resolve("starter").createDirectories(), outcome(results), Rubric.default(), seconds = 1.0)
        GradesCsv.write(listOf(starter), emptyList(), results.resolve("grades.csv"))
        GradescopeResults.write(starter, Language.ENGLISH, starter.folder.resolve("results.json"))
        // The zip brings the part of the program that has these two commands; others would have to be built first.
        home("case \$1 in starter) ;; grade) cp -r \"$results\" \"\$4\" ;; *) exit 2 ;; esac")
        unpack(zip())
        return start("setup.sh")
    }

    @Test
    fun `the zip holds the built program and nothing private`() {
        home()
        FileSystems.newFileSystem(zip(), mapOf("enablePosixFileAttributes" to "true")).use { files ->
            val names = files.getPath("/").walk().filter { it.isRegularFile() }.map { "$it".drop(1) }.toSet()
            val program =
                listOf(
                    "cga",
                    "build/cga/lib/cga.jar",
                    "build/cga/lib/lwjgl-natives-linux.jar",
                    "build/cga/grader.stamp",
                    "build/cga/grader.classpath",
                ) +
                    listOf("src/main/A.kt", "shaders/a.glsl") + StarterFiles.COPIES
            assertEquals(program.map { "cga/$it" }.toSet() + listOf("setup.sh", "run_autograder", "config.sh"), names)
            for (name in listOf("setup.sh", "run_autograder", "cga/cga")) {
                assertTrue(PosixFilePermission.OWNER_EXECUTE in Files.getPosixFilePermissions(files.getPath("/$name"))) { name }
            }
        }
    }

    @Test
    fun `it grades the submission as the instructor chose`() {
        home("for last; do [ \"\$previous\" = --gradescope ] && echo '{\"score\": 5}' >\"\$last\"; previous=\$last; done")
        assertEquals("{\"score\": 5}\n", run(zip()))
        val arguments = folder.resolve("arguments").readText()
        assertTrue(
            "--lang de" in arguments && "grade $root/submission" in arguments && "--gradescope $root/results/results.json" in arguments,
        ) {
            arguments
        }
        assertFalse("--unsafe-no-sandbox" in arguments || "--rubric" in arguments || "--edition" in arguments) { arguments }
        run(zip(AutograderConfig(Language.ENGLISH, "2022", Rubrics.bytes, unsafeNoSandbox = true)))
        val chosen = folder.resolve("arguments").readText()
        for (option in listOf("--lang en", "--edition 2022", "--rubric $root/source/rubric.json", "--unsafe-no-sandbox")) {
            assertTrue(option in chosen) { chosen }
        }
        assertTrue(root.resolve("source/rubric.json").exists())
    }

    private object Rubrics {
        val bytes = Rubric.defaultBytes()
    }

    @Test
    fun `a grader that does not start leaves valid results that blame no student`() {
        home("exit 7")
        root.resolve("results").createDirectories().resolve("results.json").writeText("of the one before")
        val results = Json.parseToJsonElement(run(zip())).jsonObject
        assertEquals("0", "${results["score"]}")
        assertTrue("not the fault of your submission" in "${results["output"]}" && "7" in "${results["output"]}")
    }

    @Test
    fun `the image is not built where the starter comes to nothing`() {
        val (exitCode, said) = setUp { Refused(FailureReason.CRASHED, "The program crashed with signal 11.") }
        assertEquals(1, exitCode, said)
        assertTrue("crashed with signal 11" in said && "could not be graded" in said) { said }
    }

    @Test
    fun `the image is built where the starter is graded`() {
        val (exitCode, said) = setUp(Fakes::mistaken)
        assertEquals(0, exitCode, said)
    }

    @Test
    fun `without a built program it is refused`() {
        home.createDirectories()
        assertTrue("./cga" in assertThrows<InputError> { zip() }.message.orEmpty())
    }

    @Test
    fun `shellcheck finds nothing in the scripts`() {
        val found = System.getenv("PATH").split(':').any { Path.of(it, "shellcheck").exists() }
        if (!found) Need.SHELLCHECK.skip("needs shellcheck: apt-get install shellcheck")
        val scripts =
            listOf("setup.sh", "run_autograder").map { "src/grader/resources/cga/grading/report/autograder/$it" } +
                "docs/examples/grade-array.sh"
        val process = ProcessBuilder(listOf("shellcheck", "-x") + scripts).directory(projectRoot).inheritIO().start()
        assertEquals(0, process.waitFor())
    }
}
