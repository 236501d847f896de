package cga.cli

import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.net.URI
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.io.path.walk

/** What the documents point to is there, and the commands that they name exist. */
class DocumentsTest {
    private val root = projectRoot.toPath()
    private val documents: List<Path> =
        root.listDirectoryEntries("*.md") +
            listOf("docs", "tests").flatMap { folder -> root.resolve(folder).walk().filter { it.extension == "md" } }

    @Test
    fun `every link leads to a file that is there, and to a place in it`() {
        val links = documents.flatMap { document -> LINK.findAll(prose(document)).map { document to it.groupValues[1] } }
        assertTrue(links.size > 100) { "${links.size} links" }
        assertEquals(emptyList<String>(), links.mapNotNull { (document, link) -> complaint(document, link) })
    }

    @Test
    fun `every command has the name and the options that the documents give it`() {
        val lines = documents.flatMap { document -> COMMAND.findAll(document.readText()).map { document to it.value } }
        assertTrue(lines.size > 50) { "${lines.size} commands" }
        assertEquals(
            emptyList<String>(),
            lines.mapNotNull { (document, line) ->
                wrongWord(line)?.let { "${name(document)}: '$line' has $it" }
            },
        )
    }

    @Test
    fun `what is wrong is found`() {
        val document = root.resolve("docs/sheet4.md")
        assertEquals("docs/sheet4.md: no/such.md is not there", complaint(document, "no/such.md"))
        assertEquals("docs/sheet4.md: #englisch is no place in sheet4.md", complaint(document, "#englisch"))
        assertEquals(null, complaint(document, "#english"))
        assertEquals("no command paint", wrongWord("./cga paint"))
        assertEquals("no option --colour", wrongWord("./cga render --colour red"))
        assertEquals(null, wrongWord("./cga render --step=4.3 --out x.png"))
    }

    private fun name(document: Path) = root.relativize(document)

    /** Without what is code: a link there is none. */
    private fun prose(
        document: Path,
    ) = document.readText().replace(Regex("(?s)```.*?```"), "").lines().filterNot { it.startsWith("    ") }.joinToString("\n")

    private fun complaint(
        document: Path,
        link: String,
    ): String? {
        if (URI(link.replace(" ", "%20")).isAbsolute) return null
        val file = if (link.startsWith("#")) document else document.resolveSibling(link.substringBefore('#')).normalize()
        if (!file.exists()) return "${name(document)}: $link is not there"
        val place = link.substringAfter('#', "").ifEmpty { return null }
        return if (place in places(file)) null else "${name(document)}: #$place is no place in ${file.fileName}"
    }

    /** Anchors, and headings as they are usually turned into some. */
    private fun places(file: Path): Set<String> {
        val text = file.readText()
        val headings = Regex("(?m)^#+ (.*)$").findAll(text).map { heading(it.groupValues[1]) }
        return (headings + Regex("<a id=\"(.*?)\">").findAll(text).map { it.groupValues[1] }).toSet()
    }

    private fun heading(text: String) = text.lowercase().filter { it.isLetterOrDigit() || it in " -_" }.replace(' ', '-')

    private fun wrongWord(line: String): String? {
        val words = line.substringBefore('#').split(' ').filter { it.isNotEmpty() }.drop(1)
        val asked = words.firstOrNull() ?: return null
        if (asked in LAUNCHERS_OWN) return null
        val command = command(asked) ?: return "no command $asked"
        val commands = listOf(command) + command.registeredSubcommands().filter { it.commandName in words }
        val known = commands.flatMap { it.registeredOptions() }.flatMap { it.names + it.secondaryNames } + "--help"
        return words.map { it.substringBefore('=') }.firstOrNull { OPTION.matches(it) && it !in known }?.let { "no option $it" }
    }

    private companion object {
        val LINK = Regex("""\]\(([^)\s]+)\)""")

        /** In a line of its own, or in backquotes. */
        val COMMAND = Regex("""(?m)(?<=^ {4}|`)\./cga [a-z][^`\n]*""")
        val OPTION = Regex("--[a-z][a-z-]*")
        val LAUNCHERS_OWN = setOf("test", "corpus", "help", "--help")
    }
}
