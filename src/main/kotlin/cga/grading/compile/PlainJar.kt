package cga.grading.compile

import cga.framework.AtomicFile
import java.nio.file.Path
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.outputStream

/** Jars without the lists of Kotlin functions in them. */
internal object PlainJar {
    private const val KOTLIN_LIST = ".kotlin_module"

    fun isNeeded(jar: Path): Boolean = ZipFile(jar.toFile()).use { zip -> zip.entries().asSequence().any { it.name.endsWith(KOTLIN_LIST) } }

    /** Copies [jar] to [target] without them. */
    fun write(jar: Path, target: Path) {
        target.toAbsolutePath().parent.createDirectories()
        AtomicFile.write(target) { part ->
            ZipFile(jar.toFile()).use { from ->
                ZipOutputStream(part.outputStream().buffered()).use { to ->
                    for (entry in from.entries().asSequence().filterNot { it.name.endsWith(KOTLIN_LIST) }) {
                        to.putNextEntry(ZipEntry(entry.name))
                        from.getInputStream(entry).use { it.copyTo(to) }
                    }
                }
            }
        }
    }
}
