package cga.grading.report

import cga.grading.findings.Check
import cga.grading.findings.FailureReason
import cga.grading.findings.Mistake
import cga.grading.findings.Part
import cga.grading.rubric.CheckState
import java.util.Locale
import java.util.Properties

/** What the reports say in one language, from `messages_en.properties` and its siblings. */
internal class Messages private constructor(
    val language: Language,
    private val entries: Map<String, String>,
) {
    private val phrases by lazy { Phrases.of(this) }

    /** What the analysis [said] in this language, in words for students; in its own where there are none. */
    fun say(said: String): String = phrases.say(said.trim())

    /** All keys. */
    val keys: Set<String> get() = entries.keys

    /** The text called [key], with [values] for {0}, {1}, … A key that is missing is a bug, found by a test. */
    fun text(key: String, vararg values: Any): String =
        PLACE.replace(checkNotNull(entries[key]) { "there is no message $key in ${language.code}" }) { match ->
            "${values[match.groupValues[1].toInt()]}"
        }

    /** Title, one sentence and hint of a mistake, a check or a failure. */
    fun of(mistake: Mistake): Words = words("mistake.${mistake.id}")

    fun of(check: Check): Words = words("check.${check.id}")

    fun of(reason: FailureReason): Words = words("failure.${reason.id}")

    fun of(state: CheckState): String = text("state.${state.id}")

    /** [parts] as they are spoken of. */
    fun list(parts: Set<Part>): String = parts.joinToString { text("part.${it.id}") }

    /** [value] with at most [digits] after the point, which is a comma in German. */
    fun number(value: Double, digits: Int = 1): String {
        val plain = "%.${digits}f".format(Locale.ROOT, value)
        val short = if ('.' in plain) plain.trimEnd('0').trimEnd('.') else plain
        return if (language == Language.GERMAN) short.replace('.', ',') else short
    }

    /** A [share] of 1 in per cent. */
    fun percent(share: Double): String =
        when {
            share > 0 && share < 0.001 -> "< ${number(0.1)} %"
            share > 10 -> "> 1000 %"
            else -> "${number(100 * share, if (share < 0.1) 1 else 0)} %"
        }

    private fun words(key: String) = Words(text("$key.title"), text("$key.text"), text("$key.hint"))

    companion object {
        private val PLACE = Regex("""\{(\d)}""")

        /** The messages in [language]. */
        fun of(language: Language): Messages {
            val name = "messages_${language.code}.properties"
            val stream = checkNotNull(Messages::class.java.getResourceAsStream(name)) { "$name is missing from the program" }
            val properties = stream.reader().use { reader -> Properties().apply { load(reader) } }
            return Messages(language, properties.entries.associate { (key, value) -> "$key" to "$value" })
        }
    }
}

/** What there is to say of one thing: its [title], [text] in one sentence, and a [hint] that does not give the solution away. */
internal class Words(
    val title: String,
    val text: String,
    val hint: String,
)
