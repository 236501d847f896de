package cga.coach.ui

import java.io.IOException
import java.nio.file.Path
import java.util.Locale
import kotlin.io.path.readLines

/** The language that the window speaks: `cga.lang` (`de` or `en`), or else the exercise's, or else the system's. */
internal object Language {
    val isGerman: Boolean = (System.getProperty("cga.lang") ?: ofExercise() ?: Locale.getDefault().language) == "de"

    private fun ofExercise(): String? =
        try {
            Path.of(".cga-starter").readLines().firstOrNull { it.startsWith(KEY) }?.removePrefix(KEY)
        } catch (_: IOException) {
            null
        }

    private const val KEY = "language "
}

/** What is said, in the window's language. */
internal fun say(
    en: String,
    de: String,
): String = if (Language.isGerman) de else en
