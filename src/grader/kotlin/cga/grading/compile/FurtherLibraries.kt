package cga.grading.compile

import cga.grading.prepared.NamedLibrary
import java.nio.file.Path
import kotlin.io.path.name

/**
 * Libraries that a submission's build file names and that this program does not bring itself.
 *
 * @property jars with all that they need, natives included.
 * @property notes which of them cannot be had, and why, in full sentences.
 */
internal class FurtherLibraries private constructor(
    val jars: List<Path>,
    val notes: List<String>,
) {
    companion object {
        private const val LWJGL = "org.lwjgl"
        private const val KOTLIN = "org.jetbrains.kotlin"

        /** Those of [named] that are not among [ours], from [repository]. A module of LWJGL is taken in the version of ours. */
        fun of(
            named: List<NamedLibrary>,
            ours: List<Path>,
            repository: Repository,
        ): FurtherLibraries {
            val lwjgl = ours.firstNotNullOfOrNull { CORE.matchEntire(it.name)?.groupValues?.get(1) }
            val notes = mutableListOf<String>()
            val jars = named.flatMap { library ->
                val version = if (library.group == LWJGL) lwjgl else library.version
                if (version == null || isThere(library.name, ours) || library.isNotForUs()) return@flatMap emptyList()
                try {
                    val artifact = Artifact(library.group, library.name, version)
                    repository.jars(artifact) + listOfNotNull(if (library.group == LWJGL) repository.natives(artifact) else null)
                } catch (e: LibraryUnavailable) {
                    emptyList<Path>().also { notes += "The library ${library.name} could not be had: ${e.message}" }
                } catch (e: IllegalArgumentException) {
                    emptyList<Path>().also { notes += "The library ${library.name} could not be had: ${e.message}" }
                }
            }
            return FurtherLibraries(
                jars.distinct().filterNot { isThere(ARTIFACT.find(it.name)?.groupValues?.get(1).orEmpty(), ours) },
                notes,
            )
        }

        /** Kotlin's own library comes with the compiler, and a list of versions is no library. */
        private fun NamedLibrary.isNotForUs() = (group == KOTLIN && name.startsWith("kotlin-stdlib")) || name.endsWith("-bom")

        private fun isThere(name: String, ours: List<Path>) =
            name.startsWith("kotlin-stdlib") || ours.any { ARTIFACT.find(it.name)?.groupValues?.get(1) == name && "natives" !in it.name }

        private val CORE = Regex("""lwjgl-(\d+(?:\.\d+)+)\.jar""")
        private val ARTIFACT = Regex("""^(.+?)-\d[\w.+-]*\.jar$""")
    }
}
