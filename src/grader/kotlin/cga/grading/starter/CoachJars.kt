package cga.grading.starter

import cga.coach.Stage
import cga.framework.InputError
import java.io.ByteArrayOutputStream
import java.net.URI
import java.nio.file.FileSystems
import java.nio.file.Files
import java.nio.file.Path
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.readBytes

/**
 * The window as the starter's library, made of this program's own classes: a jar that students compile against, and one that only it reads.
 * There is nothing of the exercise in them.
 */
internal object CoachJars {
    private const val API = "libs/cga-coach.jar"
    private const val TOOLS = "libs/cga-coach-tools.jar"

    fun all(): Map<String, ByteArray> {
        val (api, tools) = (files(Stage::class.java, "cga/coach") + files(InputError::class.java, "cga/framework")).toList().partition {
            it.first.substringBeforeLast('/') == "cga/coach"
        }
        return mapOf(API to jar(api), TOOLS to jar(tools))
    }

    /** All files below [folder] where the class [one] is from. */
    private fun files(one: Class<*>, folder: String): Map<String, ByteArray> {
        val home = Path.of(one.protectionDomain.codeSource.location.toURI())
        if (home.isDirectory()) return read(home, folder)
        return FileSystems.newFileSystem(URI("jar:${home.toUri()}"), emptyMap<String, Any>()).use { read(it.getPath("/"), folder) }
    }

    private fun read(home: Path, folder: String): Map<String, ByteArray> =
        Files.walk(home.resolve(folder)).use { paths ->
            paths.filter { it.isRegularFile() }.toList().associate { home.relativize(it).invariantSeparatorsPathString to it.readBytes() }
        }

    private fun jar(files: List<Pair<String, ByteArray>>): ByteArray {
        val bytes = ByteArrayOutputStream()
        JarOutputStream(bytes).use { jar ->
            for ((name, content) in files.sortedBy { it.first }) {
                // A fixed time: the same classes make the same jar.
                jar.putNextEntry(JarEntry(name).apply { time = 0 })
                jar.write(content)
                jar.closeEntry()
            }
        }
        return bytes.toByteArray()
    }
}
