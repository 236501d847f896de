package cga.grading.course

import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.FileVisitResult.CONTINUE
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import java.security.MessageDigest
import kotlin.io.path.inputStream
import kotlin.io.path.invariantSeparatorsPathString

/**
 * What a submission consists of, as one number: names and contents of all its files. Links count by where they point and are not followed,
 * pipes and devices by being there: nothing in a submission can make this read without end or leave it.
 */
internal object InputChecksum {
    private const val BUFFER = 1 shl 16

    /** The checksum of [path] graded with [settings]; "missing" where there is nothing that can be read. */
    fun of(path: Path, settings: String): String =
        try {
            val real = path.toRealPath()
            val files = if (Files.isDirectory(real)) filesBelow(real) else listOf(real)
            val digest = MessageDigest.getInstance("SHA-256")
            digest.update("$settings\n".toByteArray())
            for (file in files.sortedBy { real.relativize(it).invariantSeparatorsPathString }) digest.add(real, file)
            hex(digest.digest())
        } catch (_: IOException) {
            "missing"
        }

    private fun filesBelow(folder: Path): List<Path> {
        val files = mutableListOf<Path>()
        Files.walkFileTree(
            folder,
            object : SimpleFileVisitor<Path>() {
                override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult {
                    files.add(file)
                    return CONTINUE
                }

                // What cannot be entered is part of it by its name.
                override fun visitFileFailed(file: Path, e: IOException): FileVisitResult {
                    files.add(file)
                    return CONTINUE
                }
            },
        )
        return files
    }

    private fun MessageDigest.add(root: Path, file: Path) {
        val name = root.relativize(file).invariantSeparatorsPathString
        val kind =
            when {
                Files.isSymbolicLink(file) -> "link ${Files.readSymbolicLink(file)}"
                Files.isRegularFile(file) && Files.isReadable(file) -> "file ${Files.size(file)}"
                else -> "other"
            }
        // Lengths before contents: no file can look like the end of one and the beginning of the next.
        update("${name.length} $name $kind\n".toByteArray())
        if (!kind.startsWith("file")) return
        file.inputStream().use { stream ->
            val buffer = ByteArray(BUFFER)
            while (true) {
                val count = stream.read(buffer)
                if (count < 0) return
                update(buffer, 0, count)
            }
        }
    }
}
