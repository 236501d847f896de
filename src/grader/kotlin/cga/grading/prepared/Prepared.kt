package cga.grading.prepared

/**
 * Which way a submission came to be.
 *
 * @param reference where the sources of a correct one lie, below the program's home.
 */
internal enum class Kind(
    val reference: String,
) {
    /** A folder made by `./cga starter`, filled in. */
    STARTER("src/starter/src/main/kotlin"),

    /** A project of the course itself. */
    COURSE("$COURSE_PROJECT/src/main/kotlin"),
}

/** A correct project of the course, below the program's home. */
internal const val COURSE_PROJECT: String = "tests/submissions/course"

/**
 * What the job that reads a submission says of it: the manifest of the plain tree that it leaves. All paths are ours; what a student chose is
 * text for reports.
 *
 * @param mainClass the class to start, null where none was found.
 * @param kotlin the version that its build files name, null where they name none.
 * @param libraries that its build files name, whether it needs them or not.
 * @param notes what was noticed and may matter, in full sentences.
 * @param sourcesKey of the sources without names and layout, null where all are the framework's; see [cga.grading.findings.Likeness].
 */
internal class Prepared(
    val kind: Kind,
    val edition: Edition,
    val mainClass: String?,
    val kotlin: String?,
    val libraries: List<NamedLibrary>,
    val sources: List<PreparedSource>,
    val notes: List<String>,
    val sourcesKey: String? = null,
)

/**
 * A source file to be compiled.
 *
 * @param name below the submission's root, for reports.
 * @param file where it lies in [SOURCES]: its number as a folder, and a plain name.
 * @param isOurs a stand-in of ours, not the submission's.
 * @param hasReference whether [REFERENCE] has a file of the same path, which can take its place.
 */
public class PreparedSource internal constructor(
    public val name: String,
    internal val file: String,
    internal val isOurs: Boolean = false,
    internal val hasReference: Boolean = false,
) {
    internal val isKotlin: Boolean get() = file.endsWith(KOTLIN)

    internal companion object {
        const val KOTLIN = ".kt"
        const val JAVA = ".java"

        /** Where source number [index] called [name], which ends in its language, is put. Java's file names are those of its classes. */
        fun place(index: Int, name: String): String {
            val ending = if (name.endsWith(JAVA, ignoreCase = true)) JAVA else KOTLIN
            return "${"$index".padStart(DIGITS, '0')}/${stem(name)}$ending"
        }

        /** The plain name of a file called [name], without its ending. */
        fun stem(name: String): String =
            name.substringBeforeLast('.').take(LONGEST_STEM).map { if (isPlain(it)) it else '_' }.joinToString("").ifEmpty { "_" }

        /** Whether [file] is what [place] gives to source number [index]. */
        fun isPlace(index: Int, file: String): Boolean = file == place(index, file.substringAfter('/'))

        private fun isPlain(c: Char) = c in 'A'..'Z' || c in 'a'..'z' || c in '0'..'9' || c == '_' || c == '$'

        private const val DIGITS = 4
        private const val LONGEST_STEM = 100
    }
}

/**
 * A library that a build file names for the program itself, not for its tests.
 *
 * @param version null where it is left to something else, such as LWJGL's own list of versions.
 */
public data class NamedLibrary(
    public val group: String,
    public val name: String,
    public val version: String?,
)
