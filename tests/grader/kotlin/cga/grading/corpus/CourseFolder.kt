package cga.grading.corpus

import cga.grading.pipeline.HostileProject
import java.nio.file.Path
import kotlin.io.path.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeLines
import kotlin.io.path.writeText

/**
 * A whole course to measure the grader with: every tenth submission hostile or broken, the others by turns correct and mistaken ones of the
 * corpus. The same number gives the same course.
 */
internal object CourseFolder {
    /** What is written beside the submissions: `name,kind,wanted`, where `wanted` is what `grades.csv` should say. */
    const val EXPECTED = "expected.csv"
    private const val TENTH = 10

    /**
     * One submission of a course.
     *
     * @param kind `correct`, `mistaken` or `broken`.
     * @param wanted ids of the mistakes, `a|b` where either is right; of a broken one the reasons for its refusal, or `graded`.
     */
    class Member(
        val name: String,
        val kind: String,
        val wanted: String,
        val write: (Path) -> Unit,
    )

    /** The first [count] members. */
    fun members(count: Int): List<Member> {
        // Rewrites of one kind stand side by side in their files: a part of a course should have some of each.
        val correct = Corpus.correct.sortedBy { it.name.hashCode() }
        val mistaken = Corpus.mistaken.sortedBy { it.name.hashCode() }
        return List(count) { number ->
            val (round, place) = number / TENTH to number % TENTH
            val turn = round * (TENTH / 2)
            when {
                place == TENTH - 1 -> BROKEN[round % BROKEN.size].let { Member(name(number, it.name), it.kind, it.wanted, it.write) }
                place % 2 == 0 -> member(number, correct[(turn + place / 2) % correct.size])
                else -> member(number, mistaken[(turn - round + place / 2) % mistaken.size])
            }
        }
    }

    /** Writes the first [count] members and what is expected of them into [folder]. */
    fun write(
        folder: Path,
        count: Int,
    ) {
        val members = members(count)
        for (member in members) member.write(folder.resolve(member.name).createDirectories())
        folder.resolve(EXPECTED).writeLines(listOf("name,kind,wanted") + members.map { "${it.name},${it.kind},${it.wanted}" })
    }

    private fun member(
        number: Int,
        submission: Submission,
    ): Member {
        val wanted = submission.expectation.mistakes.joinToString(" ") { either -> either.map { it.id }.sorted().joinToString("|") }
        val kind = if (submission.expectation.mistakes.isEmpty()) "correct" else "mistaken"
        return Member(name(number, submission.name), kind, wanted) { Corpus.materialize(submission, it) }
    }

    private fun name(
        number: Int,
        what: String,
    ) = "%03d-%s".format(number, what)

    private fun hostile(
        behaviour: String,
        wanted: String,
        vararg arguments: String,
    ) = Member(behaviour.replace(' ', '-'), "broken", wanted) { HostileProject.write(it, behaviour, arguments.toList()) }

    /** The correct project with [edit] made to its main file. */
    private fun spoiled(
        name: String,
        wanted: String,
        edit: (String) -> String,
    ) = Member(name, "broken", wanted) { folder ->
        Corpus.materialize(Corpus.byName("plain"), folder)
        folder.resolve("src/main/kotlin/cga/exercise/Main.kt").run { writeText(edit(readText())) }
    }

    /** Twenty that a grader must survive, each once in a course of 200. */
    private val BROKEN =
        listOf(
            spoiled("does-not-compile", "graded|does-not-compile") { it.replace("fun main() {", "fun main() { val x: Int = \"one\"") },
            hostile("endless loop", "timed-out"),
            hostile("exit", "exited", "0"),
            hostile("throw", "exception", "no motorcycle"),
            hostile("output", "too-much-output"),
            hostile("fork bomb", "too-many-processes"),
            hostile("fake capture", "capture-unreadable", "CGACAPTURE", "100 points"),
            hostile("crash", "crashed"),
            hostile("memory", "out-of-memory"),
            hostile("threads", "too-many-processes"),
            spoiled("cut-off", "not-recognised|does-not-compile") { it.dropLast(it.length / 2) },
            hostile("exit amid", "exited"),
            hostile("disk", "too-much-output"),
            hostile("throw amid", "graded"),
            hostile("sockets", "graded", "9"),
            hostile("delete", "graded"),
            hostile("texture", "graded"),
            spoiled("no-main", "not-recognised|does-not-compile") { it.replace("fun main() {", "fun other() {") },
            Member("empty", "broken", "not-recognised") { },
            Member("no-code", "broken", "not-recognised") { it.resolve("photo.png").writeBytes(ByteArray(1000) { i -> i.toByte() }) },
        )
}

/** Writes a course into the folder that the first argument names; the second is how many submissions, 200 if there is none. */
fun main(args: Array<String>) {
    val folder = Path(args.first()).createDirectories()
    CourseFolder.write(folder, args.getOrNull(1)?.toInt() ?: 200)
}
