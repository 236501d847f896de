package cga.grading.submission

import cga.framework.InputError
import cga.grading.prepared.Edition
import cga.grading.prepared.PreparedTree
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.util.zip.CRC32
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.PathWalkOption
import kotlin.io.path.createDirectories
import kotlin.io.path.createLinkPointingTo
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.createTempDirectory
import kotlin.io.path.exists
import kotlin.io.path.fileSize
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

// What tests/fuzz/run.sh throws bytes at: each fails with an exception for an input that breaks the contract.

/** A folder for one input at a time, with something in it that is none of its business. */
private class Place {
    private val folder: Path = createTempDirectory("cga-fuzz")
    val decoy: Path = folder.resolve("decoy").createDirectories().resolve("file").apply { writeText(SECRET) }
    val given: Path = folder.resolve("given")
    val target: Path = folder.resolve("target")
    val elsewhere: Path = folder.resolve("made")

    init {
        Runtime.getRuntime().addShutdownHook(Thread { folder.toFile().deleteRecursively() })
    }

    /** Makes room for the next input. */
    fun clear() = listOf(given, target).forEach { it.toFile().deleteRecursively() }

    /** Throws unless only [given] and [target] have been written to, and all in [target] is plain and its own. */
    fun check() {
        check(Files.readString(decoy) == SECRET && decoy.parent.toFile().list()?.size == 1) { "the decoy was changed" }
        val others = folder.toFile().list().orEmpty().toSet() - listOf(given, target, decoy.parent).map { it.name }
        check(others.isEmpty()) { "made beside its folder: $others" }
        if (!target.exists()) return
        for (path in target.walk(PathWalkOption.INCLUDE_DIRECTORIES)) {
            check(path.isDirectory(NOFOLLOW_LINKS) || path.isRegularFile(NOFOLLOW_LINKS)) { "neither file nor folder: $path" }
            check(!path.isRegularFile(NOFOLLOW_LINKS) || path.fileSize() != SECRET.length.toLong() || path.readText() != SECRET) {
                "read through $path"
            }
        }
    }

    companion object {
        const val SECRET = "none of its business"
    }
}

private fun checkMessage(e: InputError) = check(e.message.orEmpty().trim().endsWith(".")) { "no sentence: ${e.message}" }

/** Any bytes are an archive that is unpacked into its own folder, or an [InputError]; also made a little more like tar and zip. */
internal object ArchiveFuzz {
    private val place = Place()

    /** The first byte says what the others are made into. */
    @JvmStatic
    fun fuzzerTestOneInput(data: ByteArray) {
        val rest = data.copyOfRange(minOf(1, data.size), data.size)
        val bytes = when (data.firstOrNull()) {
            't'.code.toByte() -> tar(rest)
            'z'.code.toByte() -> zip(rest)
            else -> data
        }
        place.clear()
        place.given.writeBytes(bytes)
        try {
            Archive.of(place.given)?.unpack(place.given, place.target)?.forEach { note -> check(note.endsWith(".")) { note } }
        } catch (e: NotASubmission) {
            checkMessage(e)
        }
        place.check()
    }

    /** [data] as tar blocks with the sum of each header put right. */
    private fun tar(data: ByteArray): ByteArray {
        val tar = data.copyOf((data.size / BLOCK + 1) * BLOCK)
        for (at in tar.indices step BLOCK) {
            "ustar".toByteArray().copyInto(tar, at + 257)
            "        ".toByteArray().copyInto(tar, at + 148)
            val sum = (at until at + BLOCK).sumOf { tar[it].toInt() and 0xff }
            "%06o\u0000 ".format(sum).toByteArray().copyInto(tar, at + 148)
        }
        return tar
    }

    /** [data] as a sound zip: parts between zeros are names and contents by turns. */
    private fun zip(data: ByteArray): ByteArray {
        val parts = data.toString(Charsets.UTF_8).split('\u0000')
        val bytes = ByteArrayOutputStream()
        ZipOutputStream(bytes).use { zip ->
            for ((name, content) in parts.chunked(2) { it.first() to it.last() }.distinctBy { it.first }) {
                if (name.toByteArray().size > 0xffff) continue
                val entry = ZipEntry(name).apply { crc = CRC32().apply { update(content.toByteArray()) }.value }
                zip.putNextEntry(entry)
                if (!entry.isDirectory) zip.write(content.toByteArray())
                zip.closeEntry()
            }
        }
        return bytes.toByteArray()
    }

    private const val BLOCK = 512
}

/**
 * Any folder is a plain tree whose manifest is sound, or an [InputError]. The bytes make the folder: an operation, a place, and a text, each
 * ended by a zero.
 */
internal object TreeFuzz {
    private val place = Place()

    @JvmStatic
    fun fuzzerTestOneInput(data: ByteArray) {
        place.clear()
        val given = place.given.createDirectories()
        data.toString(Charsets.UTF_8).split('\u0000').chunked(3).take(MOST).forEach { make(given, it) }
        try {
            Preparation.prepare(given, place.target.createDirectories(), null)
            check(PreparedTree.read(place.target).manifest.sources.any { it.isOurs }) { "no window" }
        } catch (e: NotASubmission) {
            checkMessage(e)
        }
        place.check()
    }

    private fun make(given: Path, words: List<String>) {
        val name = words.getOrElse(1) { "x" }
        val text = words.getOrElse(2) { "" }
        try {
            val path = given.resolve(PLACES.getOrElse(words[0].length % PLACES.size) { "" }).resolve(name.trimStart('/')).normalize()
            // Nor may the test write through the links that it makes.
            val there = generateSequence(path.parent) { it.parent }.first { it.exists(NOFOLLOW_LINKS) }
            val isInside = path.startsWith(given) && path != given && there.toRealPath().startsWith(given.toRealPath())
            if (!isInside || path.exists(NOFOLLOW_LINKS)) return
            path.parent.createDirectories()
            when (words[0].firstOrNull()) {
                'l' -> path.createSymbolicLinkPointingTo(Path.of(text))
                'd' -> path.createSymbolicLinkPointingTo(place.decoy)
                'p' -> path.createSymbolicLinkPointingTo(place.elsewhere)
                'h' -> path.createLinkPointingTo(given.resolve(text))
                'f' -> path.createDirectories()
                else -> path.writeText(text)
            }
        } catch (_: IOException) {
            // Nobody could have handed that in.
        } catch (_: InvalidPathException) {
            // Likewise.
        }
    }

    private const val MOST = 12
    private val PLACES = listOf("", "src/main/kotlin/cga/exercise", "src/main/kotlin/cga/framework", "assets", "assets/models")
}

/** Any text is a source, a build file, and what a compiler may say; it takes no longer than its length lets it. */
internal object SourceFuzz {
    @JvmStatic
    fun fuzzerTestOneInput(data: ByteArray) {
        val text = data.decodeToString()
        for (name in listOf("A.kt", "A.java")) source(SourceFile(Path.of("/given/src/$name"), "src/$name", text))
        DetectedEdition.of(listOf(SourceFile(Path.of("/A.kt"), "A.kt", text)))
        StandIn(text).source()
        val build = mapOf(Path.of("build.gradle") to text, Path.of("pom.xml") to text)
        Versions.kotlin(build)
        for (library in LibraryFinder.find(Versions.withoutComments(build).values)) {
            check(listOfNotNull(library.group, library.name, library.version).all(PreparedTree::isCoordinate)) { "$library" }
        }
    }

    private fun source(source: SourceFile) {
        check(source.packageName.split('.').none { it.isEmpty() } || source.packageName.isEmpty()) { source.packageName }
        check(source.project.startsWith("/")) { "${source.project}" }
        check(source.literals.all { it in source.text }) { "a literal that is not there" }
        source.mainClass?.takeIf(PreparedTree::isClass)
        source.declares("GameWindow")
        source.topLevelClasses
        check(source.shape.length <= 3 * source.text.length + Edition.ALL.size) { "the shape is longer than the text" }
    }
}
