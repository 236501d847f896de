package cga.framework

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Where the project's own files (`shaders/`, `assets/`) are found, wherever the program is started from.
 *
 * The launcher names the folder in the system property `cga.home`; without it the working directory is taken, as in the course.
 */
public object Home {
    /** [path] itself when absolute, otherwise below `cga.home`. */
    public fun resolve(path: String): Path {
        val given = Path.of(path)
        val home = System.getProperty("cga.home") ?: return given
        return if (given.isAbsolute) given else Path.of(home).resolve(given)
    }

    /** Reads the project file [path]; [kind] ("shader", "model", …) is how the error names it. Throws [InputError]. */
    public fun read(path: String, kind: String): ByteArray = read(resolve(path), kind)

    /** As above, for a path that is already resolved. */
    public fun read(file: Path, kind: String): ByteArray {
        if (!Files.exists(file)) throw InputError("$kind file $file does not exist: check the spelling, or put the file there.")
        if (Files.isDirectory(file)) throw InputError("$kind file $file is a folder: name the file in it.")
        return try {
            Files.readAllBytes(file)
        } catch (e: IOException) {
            throw InputError("$kind file $file cannot be read (${e.reason()}): check its permissions.", e)
        }
    }
}
