package cga.framework.model

import cga.framework.Home
import cga.framework.InputError
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * Finds what Assimp would pass over in silence: an OBJ file that names a material library or a material that is not there.
 *
 * The picture would come out grey, and nobody would know why.
 */
internal object ObjCheck {
    /** The material libraries that [obj] names, all there and with every material that it uses. Throws [InputError] otherwise. */
    fun libraries(obj: Path): List<Path> {
        val lines = String(Home.read(obj, "model")).lineSequence().map { it.trim() }
        val libraries = mutableListOf<Path>()
        val used = linkedSetOf<String>()
        for (line in lines) {
            if (line.startsWith("mtllib ")) libraries.add(beside(obj, line.substringAfter(' ').trim()))
            if (line.startsWith("usemtl ")) used += line.substringAfter(' ').trim()
        }
        val defined = libraries.flatMap(::materials).toSet()
        val missing = used - defined
        if (missing.isNotEmpty()) {
            val files = libraries.joinToString().ifEmpty { "no mtllib line" }
            throw InputError("model file $obj uses the material ${missing.first()}, which is not in its material file ($files).")
        }
        return libraries
    }

    /** The file called [name] in the folder of the model [file], which may have been written on Windows. */
    fun beside(
        file: Path,
        name: String,
    ): Path =
        try {
            file.resolveSibling(name.replace('\\', '/'))
        } catch (e: InvalidPathException) {
            throw InputError("model file $file names a file that cannot be (${e.reason}): export it again as OBJ.", e)
        }

    private fun materials(library: Path): List<String> {
        val names =
            String(Home.read(library, "material"))
                .lines()
                .map { it.trim() }
                .filter { it.startsWith("newmtl ") }
                .map { it.substringAfter(' ').trim() }
        if (names.isEmpty()) throw InputError("material file $library defines no material (no newmtl line): export the model again.")
        return names
    }
}
