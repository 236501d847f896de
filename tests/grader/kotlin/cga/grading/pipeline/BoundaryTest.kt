package cga.grading.pipeline

import cga.grading.corpus.Corpus
import cga.grading.course.CourseListener
import cga.grading.course.CourseRun
import cga.grading.course.CourseSettings
import cga.grading.course.ResultStore
import cga.grading.course.Submission
import cga.grading.findings.FailureReason
import cga.grading.findings.Graded
import cga.grading.findings.Mistake
import cga.grading.report.GradedSubmission
import cga.grading.report.Language
import cga.grading.rubric.Rubric
import cga.grading.sandbox.Hostile
import cga.grading.sandbox.Limits
import cga.grading.sandbox.Sandbox
import cga.testing.Slow
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import java.io.RandomAccessFile
import java.nio.file.Path
import java.util.zip.GZIPOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.createTempDirectory
import kotlin.io.path.deleteExisting
import kotlin.io.path.outputStream
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Submissions that aim at whoever reads them, in one course with a good one and beside a folder that is none of their business: not a byte of
 * either may change.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Slow
class BoundaryTest {
    // Its path can be written as a package.
    private val folder = createTempDirectory("boundary").toRealPath()
    private val inputs = folder.resolve("in").createDirectories()
    private val decoy = folder.resolve("decoy").createDirectories().apply { resolve("file").writeText("here") }
    private lateinit var untouched: Untouched
    private lateinit var graded: Map<String, GradedSubmission>

    @BeforeAll
    fun gradeAll() {
        val submissions = submissions()
        untouched = Untouched(decoy, inputs.resolve("good"))
        graded = grade(submissions, folder.resolve("out"))
    }

    private fun grade(
        submissions: List<Path>,
        out: Path,
        sandbox: Sandbox = Hostile.confined(),
        limits: PipelineLimits = PipelineLimits(prepare = PREPARE),
    ): Map<String, GradedSubmission> {
        val settings = CourseSettings(Rubric.default(), Language.ENGLISH, jobs = 2)
        return ResultStore.open(out, resume = false).use { store ->
            Pipeline(sandbox, null, COMPILERS, limits, sharesCompiler = submissions.size > 1).use { pipeline ->
                CourseRun(store, pipeline, settings, SILENT).run(Submission.of(submissions)).associateBy { it.name }
            }
        }
    }

    @AfterAll
    fun close() {
        folder.toFile().deleteRecursively()
    }

    private fun submissions(): List<Path> {
        val project = Corpus.sources(Corpus.byName("plain"))

        fun given(name: String, edit: (Path) -> Unit = {}): Path =
            inputs.resolve(name).also { Corpus.materialize(Corpus.byName("plain"), it) }.also(edit)

        fun Path.put(file: String, text: String) = resolve(file).createParentDirectories().writeText(text)

        fun Path.link(file: String) {
            resolve(file).deleteExisting()
            resolve(file).createSymbolicLinkPointingTo(decoy.resolve("made-through-a-link"))
        }
        val main = project.getValue("$EXERCISE/Main.kt")
        val blank = "\n".repeat(200_000)
        return listOf(
            given("good"),
            given("sources") { root ->
                val comment = "/*\npackage ${"$decoy".replace('/', '.')}\n*/\n"
                root.put("$EXERCISE/Escape.java", "${comment}package cga.exercise;\npublic class Escape { }\n")
                root.put("src/main/kotlin/helpers/Helper.kt", "fun helperOfMine() = 1\n")
                root.put("$EXERCISE/Main.kt", main.replaceFirst("import ", "import helperOfMine\nimport ") + "val used = helperOfMine()\n")
            },
            given("files") { root ->
                root.link("assets/textures/ground_diff.png")
                root.link("assets/models/motorcycle/motorcycle.obj")
                RandomAccessFile(root.resolve("assets/huge.bin").toFile(), "rw").use { it.setLength(30L shl 30) }
            },
            given("texts") { root ->
                val long = "1${".1".repeat(20_000)}"
                root.put("$EXERCISE/Long.kt", "package cga.exercise\nconst val LONG = \"${"a\\\\".repeat(10_000)}\"\n")
                root.put("$EXERCISE/Blank.kt", "${blank}package cga.exercise\n@JvmField${blank}val blank = 1\n")
                root.put("build.gradle", "kotlin_version = '$long'\nimplementation 'a:b:$long'\napi$blank\n$blank// no version\n")
                root.resolve("src/main/kotlin/cga/framework/GameWindow.kt").apply { writeText(blank + readText()) }
            },
            inputs.resolve("skipped.tar.gz").also(::tar),
            given("deep") { it.put("$EXERCISE/Deep.kt", "package cga.exercise\nval deep = ${"(".repeat(20_000)}1${")".repeat(20_000)}\n") },
        )
    }

    /** A tar of little else than an entry that is skipped. */
    private fun tar(file: Path) {
        GZIPOutputStream(file.outputStream()).use { out ->
            val header = ByteArray(BLOCK)

            fun put(at: Int, text: String) = text.toByteArray().copyInto(header, at)
            put(0, "../skipped")
            put(100, "0000644\u00000000000\u00000000000\u0000%011o\u000000000000000\u0000".format(SKIPPED))
            put(148, "        ")
            put(156, "0")
            put(257, "ustar\u000000")
            put(148, "%06o\u0000 ".format(header.sumOf { it.toInt() and 0xff }))
            out.write(header)
            repeat((SKIPPED / BLOCK).toInt()) { out.write(ByteArray(BLOCK)) }
            out.write(ByteArray(2 * BLOCK))
        }
    }

    private fun points(name: String) = graded.getValue(name).points

    private fun told(name: String) = graded.getValue(name).run { "$points ${refusal?.reason} ${refusal?.detail}" }

    @Test
    fun `nothing changes but the results`() {
        untouched.check()
        assertEquals(100.0, points("good")) { told("good") }
    }

    @Test
    fun `no failure is the grader's`() {
        val internal = graded.filterValues { it.refusal?.reason == FailureReason.INTERNAL }.keys
        assertEquals(emptySet<String>(), internal) { internal.joinToString("\n") { "$it: ${told(it)}" } }
    }

    @Test
    fun `a path in a comment is no package, and sources without a package are part of the project`() =
        assertEquals(100.0, points("sources")) { told("sources") }

    @Test
    fun `a link that leads nowhere is a file that is missing, and what is too large is left out`() {
        assertEquals(100.0, points("files")) { told("files") }
        for (name in listOf("textures/ground_diff.png", "models/motorcycle/motorcycle.obj")) {
            assertTrue("assets/$name is missing: a file of ours stands in for it" in page("files")) { name }
        }
        assertTrue("assets/huge.bin was left out" in page("files"))
    }

    private fun page(name: String) = graded.getValue(name).folder.resolve(GradedSubmission.PAGE).readText()

    @Test
    fun `long literals, long versions and many blank lines are read like any other`() =
        assertEquals(100.0, points("texts")) { told("texts") }

    @Test
    fun `what an archive has skipped counts`() {
        assertEquals(
            FailureReason.UNPACK_REFUSED to true,
            graded.getValue("skipped").refusal?.let {
                it.reason to ("its size" in it.detail)
            },
        ) { told("skipped") }
    }

    @Test
    fun `a file that breaks the compiler costs what an ordinary error costs`() {
        assertNull(graded.getValue("deep").refusal) { told("deep") }
        val refused = (graded.getValue("deep").outcome as Graded).findings.mistakes.single { it.mistake == Mistake.KOTLIN_REFUSED }
        assertEquals("$EXERCISE/Deep.kt", refused.where)
        assertTrue((points("deep") ?: 0.0) > 90) { told("deep") }
    }

    @Test
    fun `who had no room to write is not blamed for what is missing`() {
        val empty = folder.resolve("empty").createDirectories()
        val roomless = PipelineLimits(prepare = PREPARE, run = Limits(diskBytes = Long.MAX_VALUE / 2))
        val result = grade(listOf(empty), folder.resolve("full"), limits = roomless).values.single()
        assertEquals(FailureReason.INTERNAL, result.refusal?.reason)
        assertNull(result.points)
    }

    @Test
    fun `what ran without a sandbox says so everywhere`() {
        val empty = folder.resolve("empty").createDirectories()
        val result = grade(listOf(empty), folder.resolve("unconfined"), sandbox = Sandbox.unconfined()).values.single()
        assertFalse(result.outcome.facts.isConfined)
        assertTrue("without a sandbox" in result.folder.resolve(GradedSubmission.PAGE).readText())
        assertTrue("without a sandbox" in result.folder.resolve("results.json").readText())
        assertEquals(FailureReason.NOT_RECOGNIZED, result.refusal?.reason)
        assertFalse("without a sandbox" in page("good"))
    }

    private companion object {
        const val EXERCISE = "src/main/kotlin/cga/exercise"
        const val BLOCK = 512
        const val SKIPPED = 128L shl 20
        val COMPILERS: Path = Path.of("build/compilers").toAbsolutePath()

        /** What looks at a line more than once needs more. */
        val PREPARE = Limits(cpuSeconds = 15.0, wallSeconds = 60.0, diskBytes = 1280L shl 20, diskEntries = 60_000)
        val SILENT =
            object : CourseListener {
                override fun finished(submission: GradedSubmission, isNew: Boolean) = Unit

                override fun problem(message: String) = error(message)
            }
    }
}
