package cga.testing

import org.junit.jupiter.api.extension.BeforeAllCallback
import org.junit.jupiter.api.extension.ExtensionContext
import java.io.File
import java.io.File.pathSeparator
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.zip.CRC32
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.createTempFile
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.outputStream

/**
 * Names in `java.class.path`, from which the processes that tests start take their own class path, a jar in the place of each class
 * folder. A JVM maps archived classes of jars only, and starts much faster with them; an installed program has only jars as well.
 *
 * JUnit finds it as a service and calls it before the first test of every JVM. The JVM's own classes come from the folders as before.
 */
class JarredClassPath : BeforeAllCallback {
    override fun beforeAll(context: ExtensionContext) = replaced

    private companion object {
        const val PROPERTY = "java.class.path"

        val replaced by lazy<Unit> {
            val entries = System.getProperty(PROPERTY).split(pathSeparator).map(::File).filter(File::exists)
            System.setProperty(PROPERTY, entries.joinToString(pathSeparator) { "${if (it.isDirectory) jar(it) else it}" })
        }

        /** The jar of [folder]'s files, made where it is missing, with a number in its name that changes with them. */
        fun jar(folder: File): Path {
            val files =
                folder
                    .walk()
                    .filter(File::isFile)
                    .associate { it.relativeTo(folder).invariantSeparatorsPath to it.readBytes() }
                    .toSortedMap()
            val sum = CRC32().apply { for ((name, bytes) in files) update(name.toByteArray() + bytes) }
            // Both builds, and the parts' tests that run at the same time, have folders of the same name.
            val name = folder.absoluteFile.relativeTo(projectRoot).invariantSeparatorsPath.replace('/', '-')
            val jars = testingFolder.createDirectories()
            val jar = jars.resolve("$name-%08x.jar".format(sum.value))
            if (jar.exists()) return jar
            val old = jars.listDirectoryEntries("$name-????????.jar")
            val part = createTempFile(jars, name)
            ZipOutputStream(part.outputStream().buffered()).use { zip ->
                zip.setLevel(0)
                for ((path, bytes) in files) {
                    zip.putNextEntry(ZipEntry(path))
                    zip.write(bytes)
                }
            }
            // The other test JVM may be making the same. The sandbox's jobs read it, which have another user.
            part.toFile().setReadable(true, false)
            Files.move(part, jar, REPLACE_EXISTING)
            old.filter { it != jar }.forEach(Files::deleteIfExists)
            return jar
        }
    }
}
