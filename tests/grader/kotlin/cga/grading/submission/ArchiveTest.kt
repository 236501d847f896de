package cga.grading.submission

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.io.OutputStream
import java.nio.charset.Charset
import java.nio.file.Path
import java.util.zip.GZIPOutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeBytes

class ArchiveTest {
    @TempDir
    lateinit var folder: Path

    private val target get() = folder.resolve("unpacked")

    @Test
    fun `a submission is read from each kind of archive, by its bytes and not by its name`() {
        val files = MadeUp.FILES.mapKeys { "mueller/${it.key}" } + ("__MACOSX/mueller/._x" to "")
        val archives = listOf(
            zip(files.map { it.key to it.value.toByteArray() }),
            tar { out -> files.forEach { out.entry(it.key, '0', it.value.toByteArray()) } },
            tar { out -> files.forEach { out.entry(it.key, '0', it.value.toByteArray()) } }.let { bytes ->
                ByteArrayOutputStream().also { out -> GZIPOutputStream(out).use { it.write(bytes) } }.toByteArray()
            },
        )
        for ((i, bytes) in archives.withIndex()) {
            val file = folder.resolve("blatt4 ($i).zip").apply { writeBytes(bytes) }
            val submission = SubmissionReader.read(file, folder.resolve("unpacked$i"))
            assertEquals("cga.exercise.MainKt", submission.mainClass)
            assertEquals(folder.resolve("unpacked$i/mueller").toRealPath(), submission.workingDirectory)
            assertFalse(folder.resolve("unpacked$i/__MACOSX").exists())
        }
    }

    @Test
    fun `an archive in an archive is unpacked too`() {
        val inner = zip(MadeUp.FILES.map { it.key to it.value.toByteArray() })
        val outer = zip(listOf("inner.zip" to inner))
        val file = folder.resolve("outer.zip").apply { writeBytes(outer) }
        assertEquals(5, SubmissionReader.read(file, target).sources.size)
    }

    @Test
    fun `paths that lead out, absolute paths and doubles are skipped with a note`() {
        val evil = listOf(
            "../evil.txt", "a/../../evil.txt", "/evil.txt", "C:\\evil.txt", "..\\evil.txt", "ok.txt", "OK.txt", "a\u0001b",
            "x".repeat(
                300,
            ),
            "good\\nested.txt",
        )
        val notes = unpack(zip(evil.map { it to "x".toByteArray() }))
        assertEquals(setOf("ok.txt", "nested.txt"), target.walk().map { it.name }.toSet())
        assertEquals("x", target.resolve("good/nested.txt").readText())
        assertFalse(folder.resolve("evil.txt").exists() || folder.parent.resolve("evil.txt").exists())
        assertEquals(8, notes.size) { notes.joinToString("\n") }
        for (reason in listOf("leads out", "absolute", "control characters", "too long", "another of that name")) {
            assertTrue(
                notes.any {
                    reason in
                        it
                },
                reason,
            )
        }
    }

    @Test
    fun `links and devices in a tar are skipped, also what would be written through them`() {
        val outside = folder.resolve("outside").createDirectories()
        val bytes = tar { out ->
            out.entry("link", '2', link = "$outside")
            out.entry("link/through.txt", '0', "x".toByteArray())
            out.entry("hard", '1', link = "/etc/passwd")
            out.entry("pipe", '6')
            out.entry("null", '3')
        }
        val notes = unpack(bytes)
        assertEquals(listOf("link", "hard", "pipe", "null"), notes.map { it.substringBefore(' ') })
        assertFalse(outside.resolve("through.txt").exists())
        assertEquals("x", target.resolve("link/through.txt").readText())
    }

    @Test
    fun `long names in a tar are whole`() {
        val name = "a/".repeat(60) + "file.txt"
        val gnu = tar { out ->
            out.entry("././@LongLink", 'L', (name + "\u0000").toByteArray())
            out.entry(name.take(100), '0', "gnu".toByteArray())
        }
        unpack(gnu)
        assertEquals("gnu", target.resolve(name).readText())
        val record = "path=b/$name\n"
        val length = generateSequence(record.length + 1) { it + 1 }.first { "$it $record".length == it }
        val pax = tar { out ->
            out.entry("PaxHeader", 'x', "$length $record".toByteArray())
            out.entry("short", '0', "pax".toByteArray())
        }
        unpack(pax)
        assertEquals("pax", target.resolve("b/$name").readText())
    }

    @Test
    fun `names in the console's code page are read`() {
        val zipped = zip(listOf("Übung.kt" to ByteArray(1)), Charset.forName("IBM437"))
        unpack(zipped)
        assertTrue(target.resolve("Übung.kt").exists()) { target.walk().toList().toString() }
    }

    @Test
    fun `bombs are refused`() {
        assertTrue("times its size" in refusal(zip(listOf("zeros" to ByteArray(40 shl 20)))))
        assertTrue("entries" in refusal(zip((0..20_000).map { ".git/$it" to ByteArray(0) })))
    }

    @Test
    fun `what is skipped in a tar counts like all else`() {
        val bytes = tar { it.entry("../skipped", '0', ByteArray(40 shl 20)) }
        val zipped = ByteArrayOutputStream().also { out -> GZIPOutputStream(out).use { it.write(bytes) } }.toByteArray()
        assertTrue("times its size" in refusal(zipped))
    }

    @Test
    fun `broken and foreign archives are one message`() {
        val whole = zip(listOf("a" to ByteArray(1000) { (it * it).toByte() }))
        assertTrue("not a sound archive" in refusal(whole.copyOf(whole.size / 2)))
        val tar = tar { it.entry("a", '0', ByteArray(1000)) }
        assertTrue("not a sound archive" in refusal(tar.copyOf(1000)))
        val negative = tar.clone().also { "-0000000001".toByteArray().copyInto(it, 124) }
        val sum = negative.take(512).withIndex().sumOf { (i, byte) -> if (i in 148 until 156) ' '.code else byte.toInt() and 0xff }
        "%06o".format(sum).toByteArray().copyInto(negative, 148)
        assertTrue("not a sound archive" in refusal(negative))
        assertTrue("not a sound archive" in refusal(tar.clone().also { it[0] = 'b'.code.toByte() }))
        assertTrue("7-Zip" in refusal(byteArrayOf('7'.code.toByte(), 'z'.code.toByte(), 0xbc.toByte(), 0xaf.toByte(), 0x27, 0x1c)))
        assertTrue("RAR" in refusal("Rar!\u001a\u0007".toByteArray()))
    }

    private fun unpack(bytes: ByteArray): List<String> {
        val file = folder.resolve("archive").apply { writeBytes(bytes) }
        return Archive.of(file)?.unpack(file, target) ?: error("no archive")
    }

    private fun refusal(bytes: ByteArray): String {
        folder.resolve("refused").toFile().deleteRecursively()
        val file = folder.resolve("archive").apply { writeBytes(bytes) }
        return assertThrows(NotASubmission::class.java) { Archive.of(file)?.unpack(file, folder.resolve("refused")) }.message.orEmpty()
    }

    private fun zip(entries: List<Pair<String, ByteArray>>, names: Charset = Charsets.UTF_8): ByteArray {
        val out = ByteArrayOutputStream()
        ZipOutputStream(out, names).use { zip ->
            for ((name, bytes) in entries) {
                zip.putNextEntry(ZipEntry(name))
                zip.write(bytes)
            }
        }
        return out.toByteArray()
    }

    private fun tar(fill: (OutputStream) -> Unit) = ByteArrayOutputStream()
        .apply {
            fill(
                this,
            )
        }.apply { write(ByteArray(1024)) }
        .toByteArray()

    private fun OutputStream.entry(name: String, type: Char, content: ByteArray = ByteArray(0), link: String = "") {
        val header = ByteArray(512)

        fun put(at: Int, text: String) = text.toByteArray().copyInto(header, at)
        // A name of more than 100 bytes is split, as ustar has it.
        val cut = if (name.length > 100) name.indexOf('/', name.length - 101) else -1
        put(0, name.substring(cut + 1))
        if (cut > 0) put(345, name.substring(0, cut))
        put(100, "0000644\u00000000000\u00000000000\u0000%011o\u000000000000000\u0000".format(content.size))
        put(148, "        ")
        put(156, "$type")
        put(157, link)
        put(257, "ustar\u000000")
        put(148, "%06o\u0000 ".format(header.sumOf { it.toInt() and 0xff }))
        write(header)
        write(content)
        write(ByteArray((512 - content.size % 512) % 512))
    }
}
