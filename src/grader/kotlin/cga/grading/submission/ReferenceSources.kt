package cga.grading.submission

import cga.framework.Home
import cga.framework.InputError
import cga.grading.prepared.Kind
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/** The sources of a correct project of each kind of submission, to take the place of files that do not compile. */
internal object ReferenceSources {
    /** The text of the source with the package and the file name of [source]; null where there is none. */
    fun like(source: SourceFile, kind: Kind): String? {
        if (!source.isKotlin || !source.packageName.matches(Regex("""cga\.[\w.]++"""))) return null
        val file = Home.resolve("${kind.reference}/${source.packageName.replace('.', '/')}").resolve(source.path.name)
        if (!file.isRegularFile()) return null
        return try {
            Home.read(file, "source").decodeToString()
        } catch (_: InputError) {
            null
        }
    }
}
