package cga.grading.corpus

import cga.grading.starter.StarterFiles
import cga.grading.starter.StarterLanguage
import cga.testing.projectRoot
import java.nio.file.Path
import java.util.TreeMap
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/**
 * The submissions to test the grader with, `tests/submissions/`: a student's project of our own writing, and what becomes of it by
 * rewrites. `correct` are drawn from the freedoms of the sheet and deserve full points; each of `mistaken` has a mistake built in, and so
 * have those of `heldOut`, which the grader was not developed with.
 */
internal object Corpus {
    private val home: Path = projectRoot.toPath().resolve("tests/submissions")

    /** What makes a project one of the later edition. */
    private val LATER =
        setOf("later", "way-edition-structs", "way-light-cycle", "way-night-shift", "way-later-shade", "way-later-main", "way-spring-term")

    /** The file that lists the correct submissions. */
    val correctList: Path = home.resolve("correct.txt")
    val course: Sources = readSources(home.resolve("course"))
    private val reader = RewriteReader(home.resolve("overlays"))

    /** Every way to write the same, by name. */
    val rewrites: Map<String, Rewrite> = readAll("rewrites")

    /** Every mistake, by name. */
    val mistakes: Map<String, Rewrite> = readAll("mistakes")

    /** Correct in ways of their own, each tried on the plain project only, by name. */
    val students: Map<String, Rewrite> = readAll("students")

    /** Submissions without a mistake, as they are listed: by their rewrites. */
    val listed: List<Submission> by lazy { lists().map { (name, parts) -> correct(name, parts, "rewrites") } }

    /** Every mistake that the grader was not developed with, by name. */
    private val otherMistakes: Map<String, Rewrite> = readAll("held-out")
    private val allMistakes: Map<String, Rewrite> = mistakes + otherMistakes

    /** Submissions without a mistake. */
    val correct: List<Submission> by lazy { listed + students.values.map { correct(it.name, it.with + it.name, "students") } }

    /** Submissions with a mistake, or several. */
    val mistaken: List<Submission> = mistakes.values.map { submission(it.name, it.with + it.name, "mistakes") }

    /** Submissions with mistakes to judge the grader with, written without knowledge of it. */
    val heldOut: List<Submission> = otherMistakes.values.map { submission(it.name, it.with + it.name, it.file.substringBefore('-')) }

    /** Work that is not done, with the points that a person would give. */
    val unfinished: Map<String, Rewrite> = readAll("unfinished")

    /** All of them. */
    val all: List<Submission> by lazy {
        correct + mistaken + heldOut +
            unfinished.values.map { Submission(it.name, Edition.SHEET, listOf(it.name), it.expectation, "unfinished") }
    }

    private fun correct(
        name: String,
        parts: List<String>,
        set: String,
    ) = Submission(name, edition(parts), parts, Expectation.CORRECT, set)

    fun byName(name: String): Submission = all.single { it.name == name }

    /** The submission of these rewrites and mistakes. */
    fun submission(
        name: String,
        parts: List<String>,
        set: String,
    ): Submission {
        val made = parts.mapNotNull(allMistakes::get).map { it.expectation }
        return Submission(name, edition(parts), parts, Expectation(made.flatMap { it.mistakes }, made.flatMap { it.costs }.toSet()), set)
    }

    /** The submission's files, except for models and textures. Throws [IllegalStateException] where an edit does not apply. */
    fun sources(submission: Submission): Sources = sources(submission, submission.rewrites)

    /** The lines that its mistakes have changed. */
    fun edits(submission: Submission): List<EditedLines> {
        val (mistakes, others) = submission.rewrites.partition { it in allMistakes }
        return EditedLines.between(sources(submission, others), sources(submission, others + mistakes))
    }

    private fun sources(
        submission: Submission,
        names: List<String>,
    ): Sources {
        val all = names.map { name ->
            checkNotNull(
                rewrites[name] ?: allMistakes[name] ?: students[name] ?: unfinished[name],
            ) { "${submission.name}: $name is no rewrite" }
        }
        val sources = TreeMap((all.firstOrNull()?.base ?: Base.COURSE).sources())
        for (rewrite in all) {
            try {
                rewrite.edits.forEach { it.applyTo(sources) }
            } catch (e: IllegalStateException) {
                throw IllegalStateException("${submission.name}, ${rewrite.name}: ${e.message}", e)
            }
        }
        return sources
    }

    /** Writes the submission, with copies of our models and textures, into [folder], which is made where it is missing. */
    fun materialize(
        submission: Submission,
        folder: Path,
    ) {
        val sources = sources(submission)
        for ((path, text) in sources) folder.resolve(path).apply { parent.createDirectories() }.writeText(text)
        if (base(submission) != Base.COURSE) return addStarterAssets(folder)
        val shader = sources.keys.firstOrNull { "assets/shaders/" in it }
        if (shader != null) addAssets(folder.resolve(shader.substringBefore("assets/shaders/")).resolve("assets"))
    }

    private fun base(submission: Submission): Base = submission.rewrites.firstNotNullOfOrNull { unfinished[it]?.base } ?: Base.COURSE

    private fun addStarterAssets(folder: Path) {
        for ((path, content) in StarterFiles(StarterLanguage.ENGLISH).all().filterKeys { it.startsWith("assets/") && "shaders/" !in it }) {
            folder.resolve(path).apply { parent.createDirectories() }.writeBytes(content)
        }
    }

    private fun addAssets(assets: Path) {
        val ours = projectRoot.toPath().resolve("assets")
        val motorcycle = ours.resolve("motorcycle").listDirectoryEntries("*.{obj,mtl,png}").associateBy { "models/motorcycle/${it.name}" }
        val ground = GROUND.mapValues { ours.resolve("ground/${it.value}") }
        for ((path, file) in motorcycle + ground) {
            file.copyTo(assets.resolve(path).apply { parent.createDirectories() }, overwrite = true)
        }
    }

    private fun edition(parts: List<String>) = if (parts.any { it in LATER }) Edition.LATER else Edition.SHEET

    private fun readAll(folder: String): Map<String, Rewrite> {
        val all = home.resolve(folder).listDirectoryEntries("*.txt").sorted().flatMap(reader::read)
        val twice = all.groupBy { it.name }.filterValues { it.size > 1 }.keys
        check(twice.isEmpty()) { "two rewrites are called $twice" }
        return all.associateBy { it.name }
    }

    /** Lines `name: part part …`; what begins with # is a remark. */
    private fun lists(): List<Pair<String, List<String>>> =
        correctList.readLines().filter { it.isNotBlank() && !it.startsWith("#") }.map { line ->
            line.substringBefore(':').trim() to line.substringAfter(':').split(' ').filter(String::isNotEmpty)
        }

    private val GROUND =
        mapOf(
            "models/ground.obj" to "ground.obj",
            "textures/ground_diff.png" to "ground_diffuse.png",
            "textures/ground_emit.png" to "ground_emissive.png",
            "textures/ground_spec.png" to "ground_specular.png",
        )
}
