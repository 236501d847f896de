package cga.coach.host

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readLines

/** Where the student's classes come from. */
internal interface Origin {
    val mainClass: String

    /** The folder that holds the newest classes, or null while there are none. */
    val classes: Path?

    /** What the compiler has against the sources as they are, or null. */
    val complaint: List<String>?

    /** Where to look for changes. */
    val watched: List<Path>
}

/** Classes that Gradle, Maven or an IDE puts into the folder that the program was started with. */
internal class Compiled(
    override val mainClass: String,
    override val classes: Path,
) : Origin {
    override val complaint: List<String>? get() = null
    override val watched: List<Path> get() = listOf(classes)

    companion object {
        /** Of the program that calls, one of whose classes is [one]. */
        fun of(one: Class<*>): Compiled? {
            val place = one.protectionDomain.codeSource?.location?.let { Path.of(it.toURI()) } ?: return null
            val main = Thread.currentThread().stackTrace.last().className
            return if (Files.isDirectory(place)) Compiled(main, place) else null
        }
    }
}

/** Classes of a compiler that watches the sources: it says in [status] what it made. See `cga.coach.build`. */
internal class Built(
    override val mainClass: String,
    private val status: Path,
) : Origin {
    private val lines get() = if (status.exists()) status.readLines() else emptyList()
    override val classes: Path? get() = lines.firstOrNull()?.takeIf { it.isNotEmpty() }?.let(Path::of)
    override val complaint: List<String>? get() = lines.drop(1).takeIf { it.isNotEmpty() }
    override val watched: List<Path> get() = listOf(status)
}
