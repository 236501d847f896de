package cga.framework.cooked

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.ByteBuffer
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import kotlin.io.path.createFile
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.getLastModifiedTime
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.setLastModifiedTime
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** What is cooked here is a text: the two sources, joined. */
class CookedTest {
    @TempDir
    private lateinit var root: Path
    private val folder: Path by lazy { root.resolve("build/cooked") }
    private val model: Path by lazy { root.resolve("model.obj") }
    private val library: Path by lazy { root.resolve("model.mtl") }
    private var made = 0

    @BeforeEach
    fun write() {
        model.writeText("model")
        library.writeText("library")
    }

    @Test
    fun `what was made is read again, and not made again`() {
        assertNull(read())
        repeat(2) { assertEquals("model library", get()) }
        assertEquals(1, made)
        assertEquals("model library", read())
    }

    @Test
    fun `a changed source is made anew, whichever it is and whatever its time says`() {
        for ((source, text, result) in listOf(Triple(model, "MODEL", "MODEL library"), Triple(library, "LIBRARY", "MODEL LIBRARY"))) {
            get()
            val time = source.getLastModifiedTime()
            source.writeText(text)
            source.setLastModifiedTime(time)
            assertNull(read(), "$source has changed")
            assertEquals(result, get())
            assertEquals(result, read())
        }
    }

    @Test
    fun `a source that was only touched is not`() {
        get()
        model.setLastModifiedTime(FileTime.fromMillis(0))
        assertEquals("model library", read())
    }

    @Test
    fun `without one of its sources it does not count`() {
        get()
        library.deleteExisting()
        assertNull(read())
    }

    @Test
    fun `a source that changes while it is read is not kept`() {
        val result = Cooked.make(folder, listOf(model, library), FORM, ::encode) { text().also { library.writeText("new") } }
        assertEquals("model library", result)
        assertNull(read())
    }

    @Test
    fun `damage of any byte and any cut is noticed, and repaired`() {
        get()
        val file = folder.listDirectoryEntries().single()
        val whole = file.readBytes()
        val cuts = whole.indices.map { whole.copyOf(it) }
        val flips = whole.indices.map { i -> whole.copyOf().also { it[i] = (it[i].toInt() xor 0x40).toByte() } }
        for (damaged in cuts + flips + listOf(whole + 0)) {
            file.writeBytes(damaged)
            assertNull(read())
        }
        assertEquals("model library", get())
        assertTrue(whole.contentEquals(file.readBytes()))
    }

    @Test
    fun `forms of one source, and sources of one name, are kept apart`() {
        val other = root.resolve("build").resolve("model.obj")
        val files = listOf(model to "a", model to "b", other to "a").map { (source, form) -> Cooked.fileFor(folder, source, form) }
        assertEquals(files, files.distinct())
        get()
        // As if the two paths had one checksum.
        get().also { Cooked.fileFor(folder, model, FORM).toFile().copyTo(Cooked.fileFor(folder, library, FORM).toFile()) }
        assertNull(Cooked.read(folder, library, FORM, ::decode))
    }

    @Test
    fun `where nothing can be kept it is made every time`() {
        root.resolve("build").createFile()
        repeat(2) { assertEquals("model library", get()) }
        assertEquals(2, made)
        assertTrue(!folder.exists())
    }

    private fun get(): String =
        read() ?: Cooked.make(folder, listOf(model, library), FORM, ::encode) {
            made++
            text()
        }

    private fun read(): String? = Cooked.read(folder, model, FORM, ::decode)

    private fun text() = listOf(model, library).joinToString(" ") { it.readBytes().decodeToString() }

    private fun encode(text: String): ByteBuffer = ByteBuffer.wrap(text.toByteArray())

    private fun decode(bytes: ByteBuffer): String = ByteArray(bytes.remaining()).also { bytes.get(it) }.decodeToString()

    private companion object {
        const val FORM = "text"
    }
}
