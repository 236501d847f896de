package cga.grading.report

import cga.grading.findings.Check
import cga.grading.findings.FailureReason
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.rubric.CheckState
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import java.util.Properties

class MessagesTest {
    private val languages = Language.entries.associateWith(Messages::of)

    private fun Messages.allWords() = Mistake.entries.map(::of) + Check.entries.map(::of) + FailureReason.entries.map(::of)

    @ParameterizedTest
    @EnumSource
    fun `there are words for every mistake, check, failure, state and task`(language: Language) {
        val messages = languages.getValue(language)
        for (words in messages.allWords()) {
            for (text in listOf(words.title, words.text, words.hint)) {
                assertTrue(text.isNotBlank() && text == text.trim()) { text }
                assertFalse(Regex("""[{}]|TODO|\?\?|�|  """).containsMatchIn(text)) { text }
            }
            assertTrue(words.title.length <= 60 && !words.title.endsWith('.')) { words.title }
            assertTrue(words.text.endsWith('.')) { words.text }
            assertTrue(words.hint.endsWith('.') || words.hint.endsWith('?')) { words.hint }
        }
        CheckState.entries.forEach { messages.of(it) }
        Check.entries.forEach { messages.text("task.${it.task}") }
    }

    @Test
    fun `all languages have the same keys with the same places to fill in`() {
        fun places(language: Language) =
            Properties()
                .apply {
                    for (file in listOf("messages", "said")) {
                        Messages::class.java.getResourceAsStream("${file}_${language.code}.properties")!!.reader().use(::load)
                    }
                }.map { (key, value) -> "$key ${Regex("""\{\d[%°]?}""").findAll("$value").map { it.value }.sorted().toList()}" }
                .sorted()
        assertEquals(places(Language.ENGLISH), places(Language.GERMAN))
    }

    @Test
    fun `no message is left from what has no words any more`() {
        val ids =
            Mistake.entries.map { "mistake.${it.id}" } + Check.entries.map { "check.${it.id}" } +
                FailureReason.entries.map { "failure.${it.id}" }
        val strays = languages.getValue(Language.ENGLISH).keys.filter {
            Regex("(mistake|check|failure)\\..*").matches(it) &&
                it.substringBeforeLast('.') !in ids
        }
        assertEquals(emptyList<String>(), strays)
    }

    @Test
    fun `whatever the program says by a key has words, and no words are left that nothing says`() {
        val sources = projectRoot.resolve("src/grader/kotlin").walk().filter { it.extension == "kt" }.toList()
        val direct = sources.flatMap { Regex("""Message\s*\.of\(\s*"([^"$]+)"""").findAll(it.readText()).map { key -> key.groupValues[1] } }
        // The judge of the scene puts its own name before its keys.
        val scene = sources.filter { it.parentFile.endsWith("sheet4/scene") }.flatMap { file ->
            Regex(""""([a-z]+\.[a-z.-]+)"""").findAll(file.readText()).map { key -> "scene.${key.groupValues[1]}" }
        }
        val said = (direct + scene).toSet()
        val known = Properties().apply { Messages::class.java.getResourceAsStream("said_en.properties")!!.reader().use(::load) }
        assertEquals(said.sorted(), known.keys.map { "$it" }.sorted())
    }

    @Test
    fun `a message is said with names as they are, and numbers as the language writes them`() {
        val (english, german) = languages.getValue(Language.ENGLISH) to languages.getValue(Language.GERMAN)
        val scene = Message.of("picture.scene", 4.9000001)
        assertEquals("The scene after 4.9 s" to "Die Szene nach 4,9 s", english.say(scene) to german.say(scene))
        val light = Message.of("picture.light", Message.plain("spot {0}"))
        assertEquals("Light spot {0}", english.say(light))
        assertEquals("Licht (1; 0,5; 1,00e-05)", german.say(Message.of("picture.light", listOf(1, 0.5f, 1e-5))))
        assertEquals("Light a, b", english.say(Message.of("picture.light", listOf("a", "b"))))
        assertEquals(
            "Light a The scene after NaN s",
            english.say(Message.sentences(listOf(Message.of("picture.light", "a"), Message.NONE, Message.of("picture.scene", Double.NaN)))),
        )
    }

    @Test
    fun `a message that nobody knows, or that lacks its arguments, is shown as it is`() {
        val english = languages.getValue(Language.ENGLISH)
        assertEquals("no.such.key a (1)", english.say(Message.of("no.such.key", "a", Message.plain("(1)"))))
        assertEquals("Light {0}", english.say(Message.of("picture.light")))
        assertEquals("", english.say(Message("plain")))
    }

    @ParameterizedTest
    @EnumSource
    fun `no hint gives the line of code away`(language: Language) {
        val code = Regex("""\b(max|clamp|normalize|reflect|cos|dot|radians|smoothstep|toRadians|inverse|transpose|glUniform1i)\s*\(""")
        val telling = languages.getValue(language).allWords().map { it.hint }.filter { code.containsMatchIn(it) }
        assertEquals(emptyList<String>(), telling)
    }

    @Test
    fun `German is German`() {
        val (english, german) = languages.getValue(Language.ENGLISH).allWords() to languages.getValue(Language.GERMAN).allWords()
        // These two are the same in both.
        val same = english
            .zip(german)
            .flatMap { (a, b) ->
                listOf(a.title to b.title, a.text to b.text, a.hint to b.hint)
            }.filter {
                it.first ==
                    it.second
            }
        assertEquals(listOf("Emission", "Blinn-Phong"), same.map { it.first })
        val all = german.flatMap { listOf(it.title, it.text, it.hint) }.joinToString(" ")
        for (word in listOf("Punktlicht", "Scheinwerfer", "Abschwächung", "Kegel", "Normalenmatrix", "Halbvektor", "Glanzlicht")) {
            assertTrue(word in all) { word }
        }
        assertFalse(Regex("""\b(the|and|of|light|is)\b""").containsMatchIn(all)) {
            Regex(""".{30}\b(the|and|of|light|is)\b.{30}""").find(all)?.value.orEmpty()
        }
    }

    @Test
    fun `numbers are written as the language does`() {
        val (english, german) = languages.getValue(Language.ENGLISH) to languages.getValue(Language.GERMAN)
        assertEquals(listOf("71.5", "71", "0", "100"), listOf(71.5, 71.0, 0.04, 100.0).map { english.number(it) })
        assertEquals("71,5", german.number(71.5))
        assertEquals(listOf("3.2 %", "12 %", "0 %", "< 0.1 %", "> 1000 %"), listOf(0.032, 0.12, 0.0, 1e-5, 11.0).map(english::percent))
    }
}
