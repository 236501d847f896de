package cga.grading.report

import cga.grading.findings.Check
import cga.grading.findings.FailureReason
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.findings.Part
import cga.grading.rubric.CheckState
import java.math.BigDecimal
import java.math.MathContext
import java.util.Locale
import java.util.Properties
import kotlin.math.abs

/** What the reports say in one language, from `messages_en.properties` and its siblings. */
internal class Messages private constructor(
    val language: Language,
    private val entries: Map<String, String>,
) {
    private val phrases by lazy { Phrases.of(this) }

    /** What the analysis [said] in this language, in words for students; in its own where there are none. */
    fun say(said: String): String = phrases.say(said.trim())

    /** [message] in this language, in words for students. One with a key that nobody knows, which whoever wrote the findings may have invented, as it is. */
    fun say(message: Message): String =
        when (message.key) {
            Message.PLAIN -> say(message.arguments.joinToString(" "))
            Message.SENTENCES -> message.arguments.joinToString(" ") { said(it, "") }
            else -> entries[message.key]?.let { fill(it, message.arguments) } ?: "$message"
        }

    /** [template] with [arguments] in its places: `{0}`, `{0%}` for a share of 1 in per cent, `{0°}` for an angle in radians in degrees. */
    private fun fill(
        template: String,
        arguments: List<Any>,
    ): String = FORMATTED.replace(template) { place ->
        val (number, form) = place.destructured
        arguments.getOrNull(number.toInt())?.let { said(it, form) } ?: place.value
    }

    private fun said(
        argument: Any?,
        form: String,
    ): String =
        when (argument) {
            is Message -> say(argument)
            is Number -> said(argument.toDouble(), form)
            is List<*> -> {
                val isVector = argument.all { it is Number }
                val between = if (isVector && language == Language.GERMAN) "; " else ", "
                argument.joinToString(between, if (isVector) "(" else "", if (isVector) ")" else "") { said(it, form) }
            }
            else -> "$argument"
        }

    private fun said(
        number: Double,
        form: String,
    ): String =
        when (form) {
            "%" -> percent(number)
            "°" -> significant(Math.toDegrees(number)) + "°"
            else -> significant(number)
        }

    /** [value] with the digits that tell something, in the scientific notation where it is very small or large. */
    private fun significant(value: Double): String {
        if (!value.isFinite()) return "$value"
        val size = abs(value)
        val plain = if (size == 0.0 ||
            size in SMALL..LARGE
        ) {
            BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString()
        } else {
            "%.2e".format(Locale.ROOT, value)
        }
        return if (language == Language.GERMAN) plain.replace('.', ',') else plain
    }

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
            // What is nearly all is not all.
            share < 1 && share > 0.9 -> "${number(minOf(100 * share, 99.9), 1)} %"
            else -> "${number(100 * share, if (share < 0.1) 1 else 0)} %"
        }

    private fun words(key: String) = Words(text("$key.title"), text("$key.text"), text("$key.hint"))

    companion object {
        private val PLACE = Regex("""\{(\d)}""")
        private val FORMATTED = Regex("""\{(\d)([%°]?)}""")
        private val DIGITS = MathContext(4)
        private const val SMALL = 1e-4
        private const val LARGE = 1e6

        /** What the pages say of themselves, and what the analysis says. */
        private val FILES = listOf("messages", "said")

        /** The messages in [language]. */
        fun of(
            language: Language,
        ): Messages = Messages(language, FILES.map { read("${it}_${language.code}.properties") }.reduce(Map<String, String>::plus))

        private fun read(name: String): Map<String, String> {
            val stream = checkNotNull(Messages::class.java.getResourceAsStream(name)) { "$name is missing from the program" }
            val properties = stream.reader().use { reader -> Properties().apply { load(reader) } }
            return properties.entries.associate { (key, value) -> "$key" to "$value" }
        }
    }
}

/** What there is to say of one thing: its [title], [text] in one sentence, and a [hint] that does not give the solution away. */
internal class Words(
    val title: String,
    val text: String,
    val hint: String,
)
