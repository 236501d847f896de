package cga.grading.findings

import cga.framework.InputError
import cga.grading.sandbox.SafeFiles
import java.nio.file.Path
import kotlin.io.path.writeText

/** Keys of parts as a file beside the findings: a line each, the part and its key. */
internal object LikenessFile {
    private const val NAME = "likeness"
    private const val MOST_BYTES = 1000L

    fun write(keys: Map<Part, String>, folder: Path) = folder.resolve(NAME).writeText(text(keys))

    /** The keys in [folder]. Throws [InputError] where anything is not as it has to be. */
    fun read(folder: Path): Map<Part, String> = keys(SafeFiles.read(folder, NAME, MOST_BYTES).decodeToString())

    fun text(keys: Map<Part, String>): String = keys.entries.joinToString("") { (part, key) -> "${part.id} $key\n" }

    /** What [text] made of them. Throws [InputError] where anything is not as it has to be. */
    fun keys(text: String): Map<Part, String> =
        text.lines().filter(String::isNotEmpty).associate { line ->
            val part = Part.entries.find { it.id == line.substringBefore(' ') }
            val key = line.substringAfter(' ')
            if (part == null || !Likeness.isKey(key)) throw InputError("$NAME has a line that is none.")
            part to key
        }
}
