package cga.imaging.golden

import cga.framework.InputError
import cga.framework.image.FloatImage
import cga.imaging.Comparison
import cga.imaging.FloatPicture
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.time.LocalDate
import kotlin.io.path.createDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText

class GoldenStoreTest {
    @TempDir
    private lateinit var folder: Path
    private val store by lazy { GoldenStore(folder) }

    @Test
    fun `what was accepted is what comes back`() {
        val machine = LLVMPIPE.copy(settings = mapOf("GALLIVM_PERF" to "no_aos_sampling"))
        val rendered = drawn(77, machine, made = mapOf("t" to "5.3", "drive" to ""))
        store.accept("step-4.3.4", rendered, "the \"reason\"\\", date = LocalDate.of(2026, 2, 28))
        assertFiles("step-4.3.4.json", "step-4.3.4.png")
        val approved = store.approved("step-4.3.4").single()
        assertTrue(Comparison(approved.picture, rendered.picture).isIdentical)
        assertEquals("the \"reason\"\\", approved.reason)
        assertEquals(LocalDate.of(2026, 2, 28), approved.sidecar.date)
        assertEquals(machine, approved.origin.machine)
        assertEquals(emptyList<String>(), rendered.origin.changesSince(approved.origin))
        assertEquals(setOf("step-4.3.4"), store.cases())
    }

    @Test
    fun `a sidecar holds no path of the machine that made it`() {
        store.accept("case", drawn(77), "reason")
        assertFalse("$folder" in folder.resolve("case.json").readText())
    }

    @Test
    fun `float pictures are OpenEXR, and come back bit for bit`() {
        val picture = FloatPicture.opaque(FloatImage(5, 3, FloatArray(60) { it / 7f - 3 }))
        store.accept("case", drawn(0, picture = picture), "reason")
        assertFiles("case.exr", "case.json")
        assertTrue(Comparison(store.approved("case").single().picture, picture).isIdentical)
    }

    @Test
    fun `accepting replaces all that was approved, of whatever format`() {
        store.accept("case", drawn(1), "first")
        store.accept("case", drawn(2), "second", also = true)
        store.accept("case", drawn(3), "third", also = true)
        store.accept("case-2", drawn(4), "a neighbour")
        assertEquals(listOf("first", "second", "third"), store.approved("case").map { it.reason })
        assertFiles("case-2.json", "case-2.png", "case.json", "case.png", "case~2.json", "case~2.png", "case~3.json", "case~3.png")
        val floats = FloatPicture.opaque(FloatImage(2, 2, FloatArray(16)))
        store.accept("case", drawn(0, picture = floats), "fourth")
        assertFiles("case-2.json", "case-2.png", "case.exr", "case.json")
        assertEquals(listOf("fourth"), store.approved("case").map { it.reason })
    }

    @Test
    fun `also accepting the first makes it the only one`() {
        store.accept("case", drawn(1), "first", also = true)
        assertFiles("case.json", "case.png")
    }

    @Test
    fun `other files in the folder are nobody's golden`() {
        for (name in listOf("tolerance.json", "README.md", ".case.png.12.part", ".hidden.png")) folder.resolve(name).writeText("x")
        folder.resolve("folder.png").createDirectory()
        assertEquals(emptySet<String>(), store.cases())
        assertEquals(emptyList<Approved>(), store.approved("tolerance"))
    }

    @Test
    fun `a folder that is not there is told`() {
        val message = assertThrows<InputError> { GoldenStore(folder.resolve("none")).cases() }.message.orEmpty()
        assertTrue("none does not exist" in message, message)
    }

    @Test
    fun `a name that could be a path or another's number is refused`() {
        for (name in listOf("", "../a", "a/b", "a~2", "A", ".a")) {
            assertThrows<IllegalArgumentException>(name) { store.accept(name, drawn(1), "reason") }
        }
    }

    private fun assertFiles(vararg names: String) = assertEquals(names.toList(), folder.listDirectoryEntries().map { it.name }.sorted())
}
