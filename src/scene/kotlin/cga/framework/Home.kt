package cga.framework

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile

/**
 * Where the project's own files (`shaders/`, `assets/`) are found, wherever the program is started from.
 *
 * The launcher names the folder in the system property `cga.home`. Without it an installation takes the folder that its `lib/` lies in,
 * and any other program the working directory, as in the course.
 */
public object Home {
    private val installation: Path? by lazy {
        val jar = Home::class.java.protectionDomain.codeSource?.location?.let { Path.of(it.toURI()) }
        jar?.parent?.parent?.takeIf { jar.isRegularFile() && it.resolve("shaders").isDirectory() }
    }

    /** [path] itself when absolute, otherwise below the project's folder. */
    public fun resolve(path: String): Path {
        val given = Path.of(path)
        val home = System.getProperty("cga.home")?.let(Path::of) ?: installation
        return if (home == null || given.isAbsolute) given else home.resolve(given)
    }

    /** Reads the project file [path]; [kind] ("shader", "model", …) is how the error names it. Throws [InputError]. */
    public fun read(path: String, kind: String): ByteArray = read(resolve(path), kind)

    /** As above, for a path that is already resolved. */
    public fun read(file: Path, kind: String): ByteArray {
        when {
            "$file".isEmpty() -> throw InputError("the name of the $kind file is empty: name a file.")
            !Files.exists(file) -> throw InputError("$kind file $file does not exist: check the spelling, or put the file there.")
            Files.isDirectory(file) -> throw InputError("$kind file $file is a folder: name the file in it.")
            // Reading a pipe or a device might never end.
            !Files.isRegularFile(file) -> throw InputError("$kind file $file is not a plain file: copy its content to one.")
        }
        return try {
            Files.readAllBytes(file)
        } catch (e: IOException) {
            throw InputError("$kind file $file cannot be read (${e.reason()}): check its permissions.", e)
        }
    }
}
