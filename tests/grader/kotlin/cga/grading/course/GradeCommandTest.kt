package cga.grading.course

import cga.cli.grader.GradeCommand
import cga.framework.InputError
import cga.testing.Slow
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.testing.CliktCommandTestResult
import com.github.ajalt.clikt.testing.test
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.readText

@Slow
class GradeCommandTest {
    @TempDir
    lateinit var folder: Path

    private val grader = FakeGrader()

    private fun grade(vararg args: String, pipeline: () -> GradeOne = { grader }): CliktCommandTestResult =
        GradeCommand { pipeline() }.test(args.toList())

    private fun inputs(vararg what: Pair<String, String>) = FakeGrader
        .submissions(folder.resolve("in"), *what)
        .map {
            "${it.path}"
        }.toTypedArray()

    private val out get() = "${folder.resolve("out")}"

    @Test
    fun `it grades, reports, and says how it ended`() {
        val result = grade(*inputs("a" to "right", "b" to "loops", "c" to "phong"), "--out", out, "--jobs", "2", "--lang", "de")
        assertEquals(0, result.statusCode)
        assertTrue(result.stdout.startsWith("2 graded, 1 refused: $out/index.html")) { result.output }
        assertTrue("[3/3]" in result.stderr && "b: timed-out" in result.stderr && "c: 92 of 100" in result.stderr) { result.stderr }
        for (name in listOf(
            "index.html",
            "grades.csv",
            "junit.xml",
            "journal.jsonl",
        )) {
            assertTrue(folder.resolve("out/$name").exists()) { name }
        }
        assertTrue("Lights: alle Abgaben" in folder.resolve("out/index.html").readText())
    }

    @Test
    fun `a failure of the grader itself is an exit code of its own`() {
        assertEquals(1, grade(*inputs("a" to "right", "b" to "throws"), "--out", out).statusCode)
    }

    @Test
    fun `shards are graded apart and merged`() {
        val inputs = inputs(*Array(6) { "s$it" to "right" })
        for (shard in 1..2) assertEquals(0, grade(*inputs, "--out", "$out$shard", "--shard", "$shard/2").statusCode)
        assertEquals(6, grader.graded.size)
        val result = grade("--merge", "${out}1", "${out}2", "--out", out)
        assertEquals(0, result.statusCode) { result.output }
        assertEquals(7, folder.resolve("out/grades.csv").readLines().size)
        val half = grade("--merge", "${out}1", "--out", "$out-half")
        assertTrue("these are not here: 2" in half.stderr) { half.stderr }
    }

    @Test
    fun `without --resume results are safe, with it nothing is repeated`() {
        val inputs = inputs("a" to "right")
        grade(*inputs, "--out", out)
        assertTrue("--resume" in assertThrows<InputError> { grade(*inputs, "--out", out) }.message.orEmpty())
        assertEquals(0, grade(*inputs, "--out", out, "--resume").statusCode)
        assertEquals(1, grader.graded.size)
    }

    @Test
    fun `without a sandbox it refuses, and Gradescope is told`() {
        val none = { throw NoSandboxError("no sandbox: install bubblewrap") }
        assertThrows<NoSandboxError> { grade(*inputs("a" to "right"), "--out", out, pipeline = none) }
        val file = folder.resolve("results.json")
        val result = grade(*inputs("a" to "right"), "--out", out, "--gradescope", "$file", pipeline = none)
        assertEquals(1, result.statusCode)
        assertTrue("bubblewrap" in file.readText() && "\"score\":0.0" in file.readText()) { file.readText() }
    }

    @Test
    fun `doing without a sandbox is said before anything is graded, and over all results`() {
        val result = grade(*inputs("a" to "unconfined"), "--out", out, "--unsafe-no-sandbox")
        assertTrue(result.stderr.startsWith("warning: --unsafe-no-sandbox")) { result.stderr }
        for (name in listOf("index.html", "a/report.html", "a/results.json")) {
            assertTrue("without a sandbox" in folder.resolve("out/$name").readText(), name)
        }
        assertTrue("property name=\"sandbox\" value=\"none\"" in folder.resolve("out/junit.xml").readText())
        val (header, row) = folder.resolve("out/grades.csv").readLines().map { it.split(',') }
        assertEquals("no", row[header.indexOf("sandbox")])
        grade(*inputs("a" to "right"), "--out", "$out-2")
        assertFalse("without a sandbox" in folder.resolve("out-2/index.html").readText())
    }

    @Test
    fun `submissions share a compiler where that saves time, and it is ended with them`() {
        fun shares(vararg args: String): Boolean {
            var shares: Boolean? = null
            GradeCommand { grader.also { _ -> shares = it.sharesCompiler } }.test(args.toList())
            return shares ?: error("nothing was graded")
        }
        val inputs = inputs("a" to "right", "b" to "right", "c" to "right")
        assertEquals(true, shares(*inputs, "--out", "$out-1", "--jobs", "2"))
        assertEquals(1, grader.closed)
        assertEquals(false, shares(*inputs, "--out", "$out-2", "--jobs", "3"))
        assertEquals(false, shares(*inputs, "--out", "$out-3", "--jobs", "2", "--separate-compilers"))
    }

    @Test
    fun `wrong usage is told before anything is graded`() {
        val inputs = inputs("a" to "right", "b" to "right")

        fun message(vararg args: String): String {
            val error = assertThrows<RuntimeException> { GradeCommand { grader }.parse(args.toList()) }
            assertTrue(error is InputError || (error is CliktError && error !is ProgramResult)) { "$error" }
            return error.message.orEmpty()
        }
        assertTrue("one submission" in message(*inputs, "--out", out, "--gradescope", "x.json"))
        assertTrue("2/4" in message(*inputs, "--out", out, "--shard", "5/4"))
        assertTrue("rubric" in message(*inputs, "--out", out, "--rubric", "$folder/none.json"))
        message(*inputs)
        message("--out", out)
        message("$folder/nobody", "--out", out)
        assertTrue("is empty" in message("", "--out", out))
        assertTrue("is empty" in message(*inputs, "--out", ""))
        assertTrue("neither a folder nor a file" in message(*inputs, "/dev/null", "--out", out))
        message(*inputs, "--out", out, "--jobs", "0")
        message(*inputs, "--out", out, "--lang", "fr")
        message(*inputs, "--out", out, "--merge", "--shard", "1/2")
        assertEquals(0, grader.graded.size)
    }
}
