package cga.grading.corpus

import java.nio.file.Path
import java.util.Locale
import kotlin.io.path.exists
import kotlin.io.path.readLines
import kotlin.io.path.writeText
import kotlin.math.abs

/**
 * What the grader said of a submission of the corpus, as a line of `tests/submissions/judged.csv`: what is checked in is what it is expected
 * to say again.
 *
 * @param elsewhere ids of the checks that lost points although no mistake of the submission belongs to them.
 * @param wanted the points that it should have.
 * @param line whether the line that was named is the one; null where none was named, or there is none to name.
 */
internal data class Judgement(
    val name: String,
    val answer: Answer,
    val points: Double,
    val elsewhere: Set<String>,
    val wanted: Double,
    val line: Boolean? = null,
) {
    private val isOffBy get() = abs(points - wanted)

    /** In which way this is worse than what was [expected]; null where it is not. */
    fun worseThan(expected: Judgement): String? {
        val more = elsewhere - expected.elsewhere
        return when {
            answer < expected.answer -> "$answer, and was ${expected.answer}"
            more.isNotEmpty() -> "loses points of ${more.joinToString()}, where it has no mistake"
            isOffBy > expected.isOffBy + NOISE -> "$points points, and had ${expected.points}"
            expected.line == true && line != true -> "names another line"
            else -> null
        }
    }

    /** As it stands in the file. */
    fun line(): String = "$name,${answer.name.lowercase().replace('_', ' ')},$points,$wanted,${LINES[line]},${elsewhere.joinToString(" ")}"

    companion object {
        /** Points are rounded to tenths; one of them may fall either way on another processor. */
        private const val NOISE = 0.1 + 1e-9
        private val LINES = mapOf(null to "", true to "right", false to "wrong")
        private const val HEAD = "name,answer,points,wanted,line,elsewhere"

        fun of(answered: Answered): Judgement =
            Judgement(
                answered.submission.name, answered.answer, answered.points.tenths(), answered.elsewhere, answered.wanted.tenths(),
                answered.line,
            )

        private fun Double.tenths() = "%.1f".format(Locale.ROOT, this).toDouble()

        /** What [Judgement.line] wrote. */
        fun parse(line: String): Judgement {
            val (name, answer, points, wanted, right) = line.split(',')
            val checks = line.substringAfterLast(',').split(' ').filter(String::isNotEmpty).toSet()
            val isRight = LINES.entries.single { it.value == right }.key
            val said = Answer.valueOf(answer.uppercase().replace(' ', '_'))
            return Judgement(name, said, points.toDouble(), checks, wanted.toDouble(), isRight)
        }

        /** By name; none where [file] is not there. */
        fun read(file: Path): Map<String, Judgement> =
            if (file.exists()) file.readLines().drop(1).map(::parse).associateBy { it.name } else emptyMap()

        /** Writes [all] in the order of the corpus. */
        fun write(file: Path, all: Map<String, Judgement>) {
            val lines = Corpus.all.mapNotNull { all[it.name]?.line() }
            file.writeText((listOf(HEAD) + lines).joinToString("\n", postfix = "\n"))
        }
    }
}
