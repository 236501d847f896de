package cga.grading.compile

import cga.framework.Home
import cga.framework.InputError
import cga.grading.submission.Kind
import cga.grading.submission.SourceFile
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/** The sources of a correct project of each kind of submission, to take the place of files that do not compile. */
internal object ReferenceSources {
    private val FOLDERS = mapOf(Kind.STARTER to "src/scene/kotlin", Kind.COURSE to COURSE)

    /** The folder of the course's project, below the program's home. */
    const val COURSE = "tests/submissions/course/src/main/kotlin"

    /** The source with the package and the file name of [source], under its name; null where there is none. */
    fun like(source: SourceFile, kind: Kind): SourceFile? {
        if (!source.isKotlin || !source.packageName.matches(Regex("""cga(\.\w+)+"""))) return null
        val file = Home.resolve("${FOLDERS.getValue(kind)}/${source.packageName.replace('.', '/')}").resolve(source.path.name)
        if (!file.isRegularFile()) return null
        return try {
            SourceFile(source.path, source.name, Home.read(file, "source").decodeToString())
        } catch (_: InputError) {
            null
        }
    }
}
