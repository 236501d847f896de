package cga.grading.findings

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.random.Random

class FindingsFileTest {
    @TempDir
    lateinit var folder: Path

    private val findings =
        Findings(
            listOf(
                Measured(Check.CONE, 0.25, "ä \" \\ \u0000"),
                Measured(Check.ORBIT, null, ""),
                Measured(Check.MORE_LIGHTS, null, "", found = false),
            ),
            listOf(
                Found(Mistake.CONE_INSIDE_OUT, 0.01, 0.5, "spot", listOf(Mistake.UNKNOWN), setOf(Check.CONE_SPECULAR, Check.SPOT_LIGHT)),
                Found(
                    Mistake.PHONG_LEFT, 0.0, 0.1, "", explains = emptySet(), details = listOf(Message.plain("d")),
                    places = listOf(Place("a.glsl", 5).within("1\n2\n3\n4\n5\n6"), Place.of("game/Scene.kt:12")), proof = Proof(0.997, 0.4),
                ),
                Found(Mistake.MOUSE_JUMP, 0.0, 0.1, ""),
            ),
            listOf(Plot(Check.CONE, "t", "x", "y", doubleArrayOf(0.0, 1e-300), doubleArrayOf(1.0, 0.1), doubleArrayOf(-1.0, 0.3))),
            listOf(Evidence(Check.CONE, Message.plain("p"), "a.png", "b-2.png"), Evidence(null, Message.NONE, "a.png", null)),
            listOf(
                Message.plain("note"),
                Message.of("k", 0.5, "name", listOf(1.0, 2.0), Message.of("inner", emptyList<Any>()), Double.NaN),
            ),
        )

    private fun pictures() = listOf("a.png", "b-2.png").forEach { folder.resolve(it).writeBytes(byteArrayOf(1)) }

    private val file get() = folder.resolve(FindingsFile.NAME)

    @Test
    fun `what is written is read again`() {
        pictures()
        FindingsFile.write(findings, folder)
        val read = FindingsFile.read(folder)
        assertEquals(findingsJson(findings), findingsJson(read))
        assertEquals(0.25, read.checks[0].error)
        assertEquals("ä \" \\ \u0000", read.checks[0].text)
        assertEquals(listOf(true, true, false), read.checks.map { it.found })
        assertEquals(listOf(setOf(Check.CONE_SPECULAR, Check.SPOT_LIGHT), emptySet(), null), read.mistakes.map { it.explains })
        val phong = read.mistakes[1]
        assertEquals(listOf("a.glsl:5", "game/Scene.kt:12"), phong.places.map { "$it" })
        assertEquals(2 to listOf("2", "3", "4", "5", "6"), phong.places[0].first to phong.places[0].source)
        assertEquals(0.997 to 0.4, phong.proof?.explained to phong.proof?.left)
        assertEquals(1e-300, read.plots[0].x[1])
        assertEquals(listOf("b-2.png", null), read.pictures.map { it.expected })
        assertEquals(listOf(0.5, "name", listOf(1.0, 2.0), Message.of("inner", ""), "NaN"), read.notes[1].arguments)
    }

    @Test
    fun `nothing at all can be written and read`() {
        FindingsFile.write(Findings(emptyList(), emptyList(), emptyList(), emptyList(), emptyList()), folder)
        assertEquals(0, FindingsFile.read(folder).checks.size)
    }

    @Test
    fun `an error that is no number counts as not measured, and such points of a curve are left away`() {
        val plot = Plot(Check.CONE, "", "", "", doubleArrayOf(0.0, 1.0, 2.0), doubleArrayOf(1.0, Double.NaN, 3.0), DoubleArray(3))
        FindingsFile.write(
            Findings(listOf(Measured(Check.CONE, Double.NaN, "")), emptyList(), listOf(plot), emptyList(), emptyList()),
            folder,
        )
        val read = FindingsFile.read(folder)
        assertEquals(null, read.checks[0].error)
        assertEquals(listOf(0.0, 2.0), read.plots[0].x.toList())
    }

    @ParameterizedTest
    @ValueSource(
        strings = [
            "", "[]", "{", "{\"checks\": []}", "{\"more\": 1}", "{\"checks\": 5}",
            "{\"checks\": [{\"check\": \"4.9\", \"said\": {\"key\": \"k\"}}]}",
            "{\"checks\": [{\"check\": \"4.2.light\", \"said\": {\"key\": \"k\"}}, {\"check\": \"4.2.light\", \"said\": {\"key\": \"k\"}}]}",
            "{\"checks\": [{\"check\": \"4.2.light\", \"error\": 1e999, \"said\": {\"key\": \"k\"}}]}",
            "{\"checks\": [{\"check\": \"4.2.light\", \"error\": \"NaN\", \"said\": {\"key\": \"k\"}}]}",
            "{\"checks\": [{\"check\": \"4.2.light\", \"error\": -1, \"said\": {\"key\": \"k\"}}]}",
            "{\"mistakes\": [{\"mistake\": \"no-such\", \"fit\": 0, \"difference\": 0, \"where\": \"\"}]}",
            "{\"plots\": [{\"check\": \"4.3.cone\", \"title\": \"\", \"xLabel\": \"\", \"yLabel\": \"\", \"x\": [1], \"measured\": [1, 2], \"expected\": [1]}]}",
            "{\"pictures\": [{\"title\": {\"key\": \"k\"}, \"measured\": \"../a.png\"}]}",
            "{\"pictures\": [{\"title\": {\"key\": \"k\"}, \"measured\": \"/etc/passwd\"}]}",
            "{\"pictures\": [{\"title\": {\"key\": \"k\"}, \"measured\": \".hidden.png\"}]}",
            "{\"pictures\": [{\"title\": {\"key\": \"k\"}, \"measured\": \"a.png\\u0000.png\"}]}",
            "{\"pictures\": [{\"title\": {\"key\": \"k\"}, \"measured\": \"gone.png\"}]}",
        ],
    )
    fun `what is no findings is refused in one message that names the file`(text: String) {
        pictures()
        file.writeText(text)
        val message = assertThrows<InputError> { FindingsFile.read(folder) }.message.orEmpty()
        assertTrue(message.contains("$folder") && !message.contains('\n')) { message }
    }

    @Test
    fun `more than the limits is refused`() {
        fun said(text: String) = "{\"key\": \"plain\", \"with\": [$text]}"

        fun name(text: String) = "{\"name\": \"$text\"}"
        file.writeText("{\"notes\": [${said(name("n"))}]}")
        assertEquals(listOf(Message.plain("n")), FindingsFile.read(folder).notes)
        val tooMuch =
            listOf(
                List(201) { said(name("n")) }.joinToString(),
                said(name("n".repeat(4001))),
                said(List(201) { name("n") }.joinToString()),
                said("{\"list\": [${List(201) { name("n") }.joinToString()}]}"),
                said(name("n".repeat(9 shl 20))),
            )
        for (notes in tooMuch) {
            file.writeText("{\"notes\": [$notes]}")
            assertThrows<InputError> { FindingsFile.read(folder) }
        }
        file.writeText("{\"notes\": [\"n\"]}")
        assertThrows<InputError> { FindingsFile.read(folder) }
        file.writeText("[".repeat(1_000_000))
        assertThrows<InputError> { FindingsFile.read(folder) }
    }

    @Test
    fun `a picture that is a link, a folder or missing is refused`() {
        pictures()
        FindingsFile.write(findings, folder)
        Files.delete(folder.resolve("a.png"))
        assertThrows<InputError> { FindingsFile.read(folder) }
        folder.resolve("a.png").createSymbolicLinkPointingTo(Path.of("/etc/passwd"))
        assertThrows<InputError> { FindingsFile.read(folder) }
        Files.delete(folder.resolve("a.png"))
        Files.createDirectory(folder.resolve("a.png"))
        assertThrows<InputError> { FindingsFile.read(folder) }
    }

    @Test
    fun `whatever is changed in the file, it is read or refused`() {
        pictures()
        FindingsFile.write(findings, folder)
        val text = file.readText()
        val random = Random(5)
        var refused = 0
        repeat(1000) {
            val at = random.nextInt(text.length)
            val length = random.nextInt(1, 8).coerceAtMost(text.length - at)
            val piece = listOf("", "\"", "{", "]", "1e999", "null", "-", text.substring(at, at + length).repeat(3)).random(random)
            file.writeText(text.replaceRange(at, at + length, piece))
            try {
                FindingsFile.read(folder)
            } catch (_: InputError) {
                refused++
            }
        }
        // Some changes hit only text; most do not.
        assertTrue(refused in 500..999) { "$refused refused" }
    }
}
