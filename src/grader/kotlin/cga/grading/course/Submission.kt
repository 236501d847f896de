package cga.grading.course

import java.nio.file.Path
import java.text.Normalizer
import kotlin.io.path.name

/**
 * Something handed in.
 *
 * @param path the folder or archive.
 * @param name for people: the file's, without the ending of an archive; with its parent folder where two are called alike.
 * @param folder for files: letters, digits and `._-`, unlike every other also where upper and lower case are the same.
 */
public class Submission internal constructor(
    public val path: Path,
    public val name: String,
    public val folder: String,
) {
    public companion object {
        private const val MOST_LENGTH = 60
        private const val SUFFIX = 6
        private val ARCHIVE = Regex("""(?i)\.(zip|tar|tar\.gz|tgz|jar)$""")

        // What stands beside the submissions' folders, or means something to Windows.
        private val RESERVED = Regex("""(?i)index|grades|junit|course|journal|con|prn|aux|nul|com\d|lpt\d""")

        /** A submission for each of [paths], in their order; the same path twice is one. Names do not depend on the order. */
        public fun of(paths: List<Path>): List<Submission> {
            val unique = paths.distinctBy { real(it) }
            val names = unique.associateWith { ARCHIVE.replace(real(it).name, "") }
            val sharedNames = names.values.groupingBy { it }.eachCount().filterValues { it > 1 }.keys
            val folders = names.mapValues { (_, name) -> plain(name) }
            val sharedFolders = folders.values.groupingBy { it.lowercase() }.eachCount().filterValues { it > 1 }.keys
            return unique.map { path ->
                val (name, folder) = names.getValue(path) to folders.getValue(path)
                Submission(
                    path,
                    if (name in sharedNames) "${real(path).parent?.name.orEmpty()}/$name" else name,
                    if (folder.lowercase() in sharedFolders) "$folder-${sha256("${real(path)}").take(SUFFIX)}" else folder,
                )
            }
        }

        private fun real(path: Path) = path.toAbsolutePath().normalize()

        /** [name] as a plain file name: umlauts lose their dots, anything else becomes an underscore. */
        internal fun plain(name: String): String {
            val letters = Normalizer.normalize(name.replace("ß", "ss"), Normalizer.Form.NFD).replace(Regex("""\p{M}+"""), "")
            val kept = letters.replace(Regex("""[^A-Za-z0-9._-]+"""), "_").trim('.', '_', '-').take(MOST_LENGTH).trimEnd('.')
            return when {
                kept.isEmpty() -> "submission"
                RESERVED.matches(kept.substringBefore('.')) -> "${kept}_"
                else -> kept
            }
        }
    }
}
