package cga.grading.report

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

/** What the analysis says, in both languages. */
class PhrasesTest {
    private val german = Phrases.of(Messages.of(Language.GERMAN))
    private val english = Phrases.of(Messages.of(Language.ENGLISH))

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = [
            "clamped cosine between normal and light | Wie hell eine Fläche ist, gegen den Kosinus zwischen ihrer Normalen und der " +
                "Richtung zum Licht, bei 0 abgeschnitten.",
            "bike: K = (1, 0.5, 0.1); wanted (0.5, 0.05, 0.01). | bike: K = (1; 0,5; 0,1); erwartet: (0,5; 0,05; 0,01).",
            "lights[0].pos: the view matrix is applied twice; wanted: view · world position. | " +
                "lights[0].pos: die View-Matrix wird zweimal angewandt; erwartet: View-Matrix · Weltposition.",
            "Too late: the first frame has no view matrix; spot is where it was a frame before. | " +
                "Zu spät: im ersten Bild fehlt die View-Matrix; spot ist, wo es ein Bild vorher war.",
            "The axis passes the motorcycle by at 12.5 % of the camera's distance; wanted 0 %. | " +
                "Die Drehachse geht in 12,5 % des Kameraabstands am Motorrad vorbei; erwartet: 0 %.",
            "The camera turns by 0.004000, 0.004000 rad a pixel; wanted 0.002000. | " +
                "Die Kamera dreht sich um 0,004; 0,004 rad je Pixel; erwartet: 0,002.",
            "Too late: the first frame has no position of a when the ground is drawn; the first frame lacks b when the motorcycle " +
                "is drawn. | Zu spät: im ersten Bild fehlt die Position von a, wenn der Boden gezeichnet wird; im ersten Bild fehlt b, " +
                "wenn das Motorrad gezeichnet wird.",
            "light corner1Color | Licht corner1Color",
            "Kotlin 2.2.21, language level 2.0 | Kotlin 2.2.21, Sprachstufe 2.0",
            "lights[0].color: moves and turns with the motorcycle. | lights[0].color bewegt und dreht sich mit dem Motorrad.",
            "a (is b meant?), c, d (is e meant?) | a (ist b gemeint?), c, d (ist e gemeint?)",
            "Missing because of that: the point light, the cone of spot. | Deshalb fehlt: das Punktlicht, der Kegel von spot.",
        ],
    )
    fun `a German report says in German what the analysis says`(said: String, expected: String) {
        assertEquals(expected, german.say(said))
    }

    @Test
    fun `a mistake is called by its title, in each language`() {
        assertEquals("The cone is inside out (spot)", english.say("cone-inside-out spot"))
        assertFalse("cone-inside-out" in german.say("cone-inside-out spot; cone-inside-out"))
    }

    @Test
    fun `logs of several lines stay whole`() {
        val log = "fragment shader (a stand-in takes its place)\n0:12(3): error: syntax error\n0:13: too"
        assertTrue(german.say("shader failed: $log").endsWith("was was ist.\n0:12(3): error: syntax error\n0:13: too"))
    }

    @Test
    fun `what nobody has words for stays as it is, however odd`() {
        val odd = listOf("Oh, {0} \$1 \\E (.*)", "x is ".repeat(500), ": ".repeat(1000), "a; b", "")
        for (text in odd) assertEquals(text, german.say(text))
    }

    @Test
    fun `every phrase has German words, with the same places to fill in, and is itself found`() {
        for (block in Phrases.blocks()) {
            val places = { text: String -> Regex("""\{(\d)[!.]?}""").findAll(text).map { it.groupValues[1] }.sorted().toList() }
            val codes = block.drop(1).map { it.take(3) }
            assertTrue(codes == listOf("de:") || codes == listOf("en:", "de:")) { "$block" }
            for (words in block.drop(1)) assertTrue(places(words) == places(block[0]) || places(words).isEmpty()) { "$block" }
            val example = Regex("""\{(\d)[.]?}""").replace(block[0]) { "place${it.groupValues[1]}" }
            assertTrue(german.knows(example) && english.knows(example)) { example }
            val words = block.last().removePrefix("de: ")
            assertFalse(Regex("""\b(the|and|of|is|by|wanted|no)\b""").containsMatchIn(words)) { words }
        }
    }
}
