package cga.grading.compile

import cga.framework.AtomicFile
import java.nio.file.Path
import java.util.zip.CRC32
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.outputStream
import kotlin.io.path.readBytes

/**
 * Jars that an old Kotlin compiler takes for Java of its own time: without the lists of Kotlin functions, with classes whose notes on their
 * Kotlin have another name, and of Java 8's class files. To compile against only: nothing else in them is changed.
 */
internal object PlainJar {
    private const val KOTLIN_LIST = ".kotlin_module"
    private const val NOTE = "Lkotlin/Metadata;"
    private const val OTHER = "Lkotlin/Metadat_;"

    /** In a class file the version stands behind 0xCAFEBABE and two bytes more. */
    private const val VERSION_AT = 7
    private const val JAVA_8: Byte = 52

    fun isNeeded(jar: Path): Boolean =
        ZipFile(jar.toFile()).use { zip ->
            zip.entries().asSequence().any { it.name.endsWith(KOTLIN_LIST) || (it.isClass() && NOTE in text(zip.read(it))) }
        }

    /** A name for what [jar] becomes, another for other contents. */
    fun name(jar: Path): String = "plain-%08x-%s".format(CRC32().apply { update(jar.readBytes()) }.value, jar.fileName)

    /** Copies [jar] to [target] as such. */
    fun write(jar: Path, target: Path) {
        target.toAbsolutePath().parent.createDirectories()
        AtomicFile.write(target) { part ->
            ZipFile(jar.toFile()).use { from ->
                ZipOutputStream(part.outputStream().buffered()).use { to ->
                    for (entry in from.entries().asSequence().filterNot { it.name.endsWith(KOTLIN_LIST) }) {
                        to.putNextEntry(ZipEntry(entry.name))
                        val bytes = from.read(entry)
                        to.write(if (entry.isClass()) plain(bytes) else bytes)
                    }
                }
            }
        }
    }

    private fun plain(bytes: ByteArray): ByteArray {
        val text = text(bytes)
        val plain = if (NOTE in text) text.replace(NOTE, OTHER).toByteArray(Charsets.ISO_8859_1) else bytes
        if (plain.size > VERSION_AT && plain[VERSION_AT] > JAVA_8) plain[VERSION_AT] = JAVA_8
        return plain
    }

    // Every byte a character: lengths stay as they are.
    private fun text(bytes: ByteArray) = String(bytes, Charsets.ISO_8859_1)

    private fun ZipFile.read(entry: ZipEntry) = getInputStream(entry).use { it.readBytes() }

    // What is kept for other versions of Java is not looked at by Kotlin.
    private fun ZipEntry.isClass() = name.endsWith(".class") && !name.startsWith("META-INF/") && name != "module-info.class"
}
