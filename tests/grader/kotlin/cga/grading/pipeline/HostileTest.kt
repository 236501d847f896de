package cga.grading.pipeline

import cga.grading.corpus.Corpus
import cga.grading.corpus.CorpusCaptures
import cga.grading.course.CourseListener
import cga.grading.course.CourseRun
import cga.grading.course.CourseSettings
import cga.grading.course.ResultStore
import cga.grading.course.Submission
import cga.grading.findings.Check
import cga.grading.findings.FailureReason
import cga.grading.findings.Graded
import cga.grading.findings.Mistake
import cga.grading.findings.Part
import cga.grading.report.GradedSubmission
import cga.grading.report.Language
import cga.grading.rubric.CheckState
import cga.grading.rubric.Rubric
import cga.grading.sandbox.Hostile
import cga.grading.sandbox.Limits
import cga.grading.sheet4.scene.SceneJudge
import cga.testing.Slow
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestInstance
import java.net.InetAddress
import java.net.ServerSocket
import java.net.SocketTimeoutException
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.PathWalkOption
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.createTempDirectory
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.outputStream
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.relativeTo
import kotlin.io.path.setPosixFilePermissions
import kotlin.io.path.walk
import kotlin.io.path.writeText

/** One course of hostile submissions and a good one, through the whole pipeline, two at a time: each costs only itself. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Slow
class HostileTest {
    private val folder = createTempDirectory("hostile-course")
    private val inputs = folder.resolve("in").createDirectories()
    private val out = folder.resolve("out")
    private val secret = folder.resolve("rubric.json").apply { writeText(SECRET) }
    private val precious = folder.resolve("precious").createDirectories().resolve("file").apply { writeText("here") }
    private val listener = ServerSocket(0, 1, InetAddress.getLoopbackAddress())
    private lateinit var untouched: Untouched
    private lateinit var graded: Map<String, GradedSubmission>

    @BeforeAll
    fun gradeAll() {
        val submissions = submissions()
        inputs.resolve("read/assets/link").createSymbolicLinkPointingTo(secret)
        untouched = Untouched(precious.parent, inputs.resolve("good"), secret)
        // An honest run takes a fifth of the processor's time.
        val limits = PipelineLimits(run = Limits(wallSeconds = 60.0, cpuSeconds = 10.0))
        val settings = CourseSettings(Rubric.default(), Language.ENGLISH, jobs = 2)
        ResultStore.open(out, resume = false).use { store ->
            Pipeline(Hostile.confined(), null, COMPILERS, limits, sharesCompiler = true).use { pipeline ->
                graded = CourseRun(store, pipeline, settings, SILENT).run(Submission.of(submissions)).associateBy { it.name }
            }
        }
    }

    @AfterAll
    fun close() {
        listener.close()
        folder.toFile().deleteRecursively()
    }

    private fun submissions(): List<Path> {
        fun project(
            name: String,
            behaviour: String,
            vararg arguments: String,
        ) = HostileProject.write(inputs.resolve(name), behaviour, arguments.toList())

        fun shader(name: String, declaration: String, statement: String) = HostileProject.writeShader(
            inputs.resolve(name),
            declaration,
            statement,
        )
        return listOf(
            project("good", "nothing"),
            project("loop", "endless loop"),
            project("exit 0", "exit", "0"),
            project("exit 2", "exit", "2"),
            project("exit 3", "exit", "3"),
            project("exit 4", "exit", "4"),
            project("halt 3", "halt", "3"),
            project("exit amid", "exit amid"),
            project("throw", "throw", "no motorcycle"),
            project("throw amid", "throw amid"),
            project("crash", "crash"),
            project("fork bomb", "fork bomb"),
            project("threads", "threads"),
            project("output", "output"),
            project("disk", "disk"),
            project("memory", "memory"),
            project("delete", "delete", "${precious.parent}", "${inputs.resolve("good")}", System.getProperty("user.home")),
            project(
                "read", "read", "assets/link", "/etc/passwd", "/etc/shadow", "$secret",
                "${inputs.resolve(
                    "good/assets/behaviour.txt",
                )}",
                "$out/journal.jsonl",
            ),
            project("sockets", "sockets", "${listener.localPort}"),
            project("fake capture", "fake capture", "CGACAPTURE", "100 points"),
            project("fake findings", "fake findings", """{"version":1,"checks":[]}"""),
            project("link as capture", "link as capture", "$secret"),
            project("borrowed capture", "borrowed capture").also(::lend),
            project(MARKUP, "throw", "<img src=x onerror=alert(2)>"),
            project("texture", "texture"),
            shader("shader loop", "uniform float never;", "float z = 1.0; while (z > never * 0.0 - 1.0) z = mod(z + 1.0, 5.0);"),
            shader("uniform array", "uniform vec4 huge[100000000];", "if (huge[int(shininess) * 1000].x > 1.0) discard;"),
            shader("refused", "", "vec3 direction = lightDirection;"),
            archive(),
            project("private", "nothing").also(::hide),
        )
    }

    /** Gives [project] the capture of a correct submission, which it has the worker's file be; its own shaders draw nothing. */
    private fun lend(project: Path) {
        val capture = CorpusCaptures().use { it.of(Corpus.byName("plain")) }
        capture.copyTo(project.resolve("assets/capture.bin"))
        project.resolve("assets/shaders/tron_frag.glsl").writeText("#version 330 core\nvoid main() { }\n")
    }

    /** As a mail program or a learning platform saves it. */
    private fun hide(project: Path) {
        for (path in project.walk(PathWalkOption.INCLUDE_DIRECTORIES)) {
            path.setPosixFilePermissions(PosixFilePermissions.fromString(if (path.isDirectory()) "rwx------" else "rw-------"))
        }
    }

    /** The good project with links and ways out among its entries. */
    private fun archive(): Path {
        val good = inputs.resolve("good")
        val file = inputs.resolve("archive.zip")
        ZipOutputStream(file.outputStream()).use { zip ->
            fun entry(name: String, bytes: ByteArray) {
                zip.putNextEntry(ZipEntry(name))
                zip.write(bytes)
                zip.closeEntry()
            }
            entry("../../../../../../precious/file", "gone".toByteArray())
            entry("${precious.parent}/file", "gone".toByteArray())
            entry("assets/../../../../../precious/file", "gone".toByteArray())
            for (path in good.walk()) entry("${path.relativeTo(good)}", path.readBytes())
        }
        return file
    }

    private fun reason(name: String): FailureReason? = graded.getValue(name).refusal?.reason

    private fun detail(name: String): String = graded.getValue(name).refusal?.detail.orEmpty()

    private fun page(name: String): String = graded.getValue(name).folder.resolve(GradedSubmission.PAGE).readText()

    private fun everything(name: String): String = graded
        .getValue(
            name,
        ).folder
        .walk()
        .joinToString("\n") { it.readBytes().decodeToString() }

    private fun logs(name: String): String = graded.getValue(name).outcome.facts.logs.joinToString("\n") { it.text }

    @Test
    fun `what is good keeps all its points, and no result is lost`() {
        assertEquals(inputs.listDirectoryEntries().size, graded.size)
        assertEquals(100.0, graded.getValue("good").points)
        assertTrue(graded.keys.all { graded.getValue(it).folder.resolve(GradedSubmission.PAGE).exists() })
        assertFalse(
            graded.values.any { it.refusal?.reason == FailureReason.INTERNAL },
        ) { graded.keys.associateWith { reason(it) }.toString() }
    }

    @Test
    fun `an endless loop is ended`() = assertEquals(FailureReason.TIMED_OUT, reason("loop"))

    @Test
    fun `an exit is an exit whatever its code, also with the codes of our own`() {
        for (name in listOf("exit 0", "exit 2", "exit 3", "exit 4", "halt 3")) assertEquals(FailureReason.EXITED, reason(name), name)
        assertEquals(FailureReason.EXITED, reason("exit amid"))
        assertTrue("after 2 of 17 pictures" in detail("exit amid")) { detail("exit amid") }
    }

    @Test
    fun `an exception is told with the student's own lines`() {
        assertEquals(FailureReason.EXCEPTION, reason("throw"))
        assertTrue("no motorcycle" in detail("throw") && "Behaviour.kt:" in detail("throw")) { detail("throw") }
    }

    @Test
    fun `what was drawn before an exception is graded, and the exception is told`() {
        assertNotNull(graded.getValue("throw amid").grade)
        assertTrue("the third picture" in page("throw amid"))
    }

    @Test
    fun `a native crash is a crash`() = assertEquals(FailureReason.CRASHED, reason("crash"))

    @Test
    fun `neither processes nor threads multiply without end`() {
        assertEquals(FailureReason.TOO_MANY_PROCESSES, reason("fork bomb"))
        assertEquals(FailureReason.TOO_MANY_PROCESSES, reason("threads"))
    }

    @Test
    fun `output, disk and memory have an end`() {
        assertEquals(FailureReason.TOO_MUCH_OUTPUT, reason("output"))
        assertEquals(FailureReason.TOO_MUCH_OUTPUT, reason("disk"))
        assertEquals(FailureReason.OUT_OF_MEMORY, reason("memory"))
    }

    @Test
    fun `what is deleted is only its own`() {
        untouched.check()
        assertTrue(inputs.resolve("delete/assets/behaviour.txt").exists())
        assertTrue(Path.of(System.getProperty("user.home")).exists())
        assertEquals(100.0, graded.getValue("delete").points) { detail("delete") }
    }

    @Test
    fun `nothing that is none of its business can be read`() {
        val said = logs("read")
        assertEquals(6, said.lines().count { it == "cannot read it" }) { said }
        val names = listOf("good", "fork bomb", precious.parent.name, secret.name)
        // The folder that holds all submissions is only a way to its own.
        assertTrue(said.lines().none { line -> names.any { line.endsWith("/$it") } }) { said }
        assertFalse(SECRET in everything("read") || "root:x:" in everything("read"))
    }

    @Test
    fun `no socket is opened`() {
        listener.soTimeout = 1
        assertThrows(SocketTimeoutException::class.java) { listener.accept() }
        assertEquals(2, logs("sockets").lines().count { "Failure(java.net.SocketException" in it }) { logs("sockets") }
    }

    @Test
    fun `what it writes in the place of our files is not believed`() {
        assertEquals(FailureReason.CAPTURE_UNREADABLE, reason("fake capture"))
        assertEquals(FailureReason.EXITED, reason("fake findings"))
        assertEquals(FailureReason.EXITED, reason("link as capture"))
        assertFalse(SECRET in everything("link as capture"))
    }

    @Test
    fun `somebody else's capture is marked in both, and so is the same Kotlin`() {
        val twins = graded.getValue("borrowed capture").twins
        assertEquals(100.0, graded.getValue("borrowed capture").points) { detail("borrowed capture") }
        assertEquals(Part.entries.toSet(), twins["good"])
        assertEquals(Part.entries.toSet(), graded.getValue("good").twins["borrowed capture"])
        assertTrue("The same in another submission, but for names and layout: Kotlin, shaders, drawn frames." in page("borrowed capture"))
        assertEquals(setOf(Part.KOTLIN), graded.getValue("throw").twins["good"])
    }

    @Test
    fun `a submission that only its owner may read is read all the same`() = assertEquals(100.0, graded.getValue("private").points) {
        detail("private")
    }

    @Test
    fun `markup is text in the report`() {
        assertEquals(FailureReason.EXCEPTION, reason(MARKUP))
        val page = page(MARKUP)
        assertTrue("&lt;img src=x" in page && "&lt;script&gt;alert(1)" in page) { detail(MARKUP) }
        assertFalse("<script>alert(1)" in page || "<img src=x" in page)
    }

    @Test
    fun `a texture of 32768 squared is an error of OpenGL's and no more`() {
        assertNull(reason("texture")) { detail("texture") }
        assertTrue("GL_INVALID_VALUE glTexImage2D" in page("texture"))
    }

    @Test
    fun `an endless loop in a shader is ended, by the driver or by us`() {
        // Mesa 22.3.6 leaves the loop after 65 535 rounds; newer ones do not.
        val reason = reason("shader loop")
        assertTrue(reason == null || reason == FailureReason.TIMED_OUT) { "$reason ${detail("shader loop")}" }
    }

    @Test
    fun `a uniform array of a hundred million is a shader that does not work`() {
        val reason = reason("uniform array")
        val isTold = reason == null && Regex("(shader|link) failed").containsMatchIn(page("uniform array"))
        assertTrue(isTold || reason in setOf(FailureReason.OUT_OF_MEMORY, FailureReason.EXCEPTION, FailureReason.TIMED_OUT)) {
            "$reason ${detail("uniform array")}"
        }
    }

    @Test
    fun `a shader that does not compile is told with its line, and what the scene does is graded all the same`() {
        val refused = graded.getValue("refused")
        assertNull(reason("refused")) { detail("refused") }
        assertEquals(listOf(Mistake.SHADER_REFUSED), (refused.outcome as Graded).findings.mistakes.map { it.mistake })
        val open = refused.grade?.checks.orEmpty().filter { it.points == null }.map { it.check }.toSet()
        // What shaders compute is for a person to look at: all that no scene is judged by, and the cone.
        assertEquals(Check.entries.toSet() - SceneJudge.CHECKS + Check.CONE, open)
        val others = refused.grade?.checks.orEmpty().filter { it.check !in open && it.check != Check.ORDER }
        assertTrue(others.all { it.state == CheckState.RIGHT }) { others.joinToString { "${it.check} ${it.state}" } }
        assertTrue("lightDirection" in page("refused"))
    }

    @Test
    fun `an archive cannot write beside its own folder`() {
        assertEquals(100.0, graded.getValue("archive").points) { detail("archive") }
        assertTrue("was not unpacked" in page("archive"))
    }

    private companion object {
        const val MARKUP = "<script>alert(1)"
        const val SECRET = "the-secret-of-the-rubric"
        val COMPILERS: Path = Path.of("build/compilers").toAbsolutePath()
        val SILENT =
            object : CourseListener {
                override fun finished(submission: GradedSubmission, isNew: Boolean) = Unit

                override fun problem(message: String) = error(message)
            }
    }
}
