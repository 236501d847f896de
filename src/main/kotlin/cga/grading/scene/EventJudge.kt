package cga.grading.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import kotlin.math.min

/**
 * Do the calls beside the drawing explain what is missing? What is not missed is no mistake: a driver also drops uniforms that a shader
 * does not need.
 *
 * @param uniforms the programs' active uniforms, to tell what a misspelt name was meant to be.
 */
internal class EventJudge(
    private val events: List<CapturedEvent>,
    private val uniforms: Set<String>,
    private val book: Notebook,
) {
    fun judge() {
        absent()
        beforeUse()
        for (text in texts(EventKind.GL_ERROR)) book.note("OpenGL reported $text.")
    }

    private fun absent() {
        val names = texts(EventKind.UNIFORM_ABSENT).filter(::matters)
        if (names.isEmpty()) return
        if (book.missing.isEmpty()) {
            book.note("Set but in no program: ${names.take(MOST_NAMES).joinToString()}. The picture lacks nothing of them.")
        } else {
            val likeliest = names.sortedBy { distance(it) }.take(MOST_NAMES)
            book.found(Mistake.UNIFORM_ABSENT, 0.0, 1.0, likeliest.joinToString(transform = ::suggestion))
            book.remove(Mistake.LIGHT_MISSING)
            book.note("Missing: ${book.missing.joinToString()}.")
        }
    }

    private fun beforeUse() {
        val calls = texts(EventKind.UNIFORM_WITHOUT_PROGRAM)
        if (calls.isEmpty() || book.has(Mistake.UNIFORM_BEFORE_USE)) return
        if (book.missing.isEmpty()) {
            book.note("Uniforms were set while their program was not in use (${calls.joinToString()}); the picture lacks nothing of them.")
        } else {
            book.measured(Check.ORDER, 1.0, "${calls.joinToString()} without the program in use; missing: ${book.missing.joinToString()}")
            book.found(Mistake.UNIFORM_BEFORE_USE, 0.0, 1.0, calls.joinToString())
        }
    }

    private fun texts(kind: EventKind) = events.filter { it.kind == kind }.map { it.text.take(LONGEST_NAME) }.distinct().take(MOST_TEXTS)

    /** Whether a light could depend on it. */
    private fun matters(name: String) = LIGHT_WORDS.containsMatchIn(name) || distance(name) <= TYPO

    private fun suggestion(name: String): String {
        val meant = nearest(name)
        return if (meant == null || distance(name) > name.length / 2) name else "$name (is $meant meant?)"
    }

    private fun nearest(name: String): String? = uniforms.minByOrNull { editDistance(it, name) }

    private fun distance(name: String): Int = nearest(name)?.let { editDistance(it, name) } ?: Int.MAX_VALUE

    private companion object {
        const val MOST_TEXTS = 64
        const val MOST_NAMES = 5
        const val LONGEST_NAME = 200
        const val TYPO = 2
        val LIGHT_WORDS =
            Regex("light|licht|lamp|point|punkt|spot|colou?r|farbe|pos|dir|att|cone|angle|winkel|corner", RegexOption.IGNORE_CASE)
    }
}

/** How many letters must be put in, taken out or changed to make [a] into [b]; capital letters count as small ones. */
internal fun editDistance(
    a: String,
    b: String,
): Int {
    var row = IntArray(b.length + 1) { it }
    for (i in a.indices) {
        val next = IntArray(b.length + 1)
        next[0] = i + 1
        for (j in b.indices) {
            val change = if (a[i].equals(b[j], ignoreCase = true)) 0 else 1
            next[j + 1] = minOf(row[j] + change, min(row[j + 1], next[j]) + 1)
        }
        row = next
    }
    return row[b.length]
}
