package cga.grading.compile

import cga.grading.prepared.NamedLibrary
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import kotlin.io.path.exists
import kotlin.math.abs

/**
 * The Kotlin compilers that submissions are compiled with, fetched when they are first needed.
 *
 * @param folder where what is downloaded and made is kept, from one run of the grader to the next.
 */
public class CompilerCache(
    private val folder: Path,
    private val repository: Repository = Repository(folder.resolve("repository")),
) {
    private val compilers = ConcurrentHashMap<String, KotlinCompiler>()

    /** The newest compiler at the lowest level that it knows. Throws [LibraryUnavailable]. */
    public fun newest(): KotlinCompiler = compiler(NEWEST, LOWEST_LEVEL)

    /** The compiler of [version], or of the nearest one that exists; of a middling one when null. Throws [LibraryUnavailable]. */
    public fun named(version: String?): KotlinCompiler {
        val wanted = version ?: MIDDLING
        return try {
            compiler(wanted, null)
        } catch (e: LibraryUnavailable) {
            if (!e.isUnknown) throw e
            compiler(nearest(wanted, repository.versions(GROUP, COMPILER)) ?: throw e, null)
        }
    }

    /**
     * [library] as [compiler] can read it. What newer compilers put into jars breaks older ones; without that a library is plain Java to
     * Kotlin, as JOML was when those compilers were new.
     */
    internal fun readable(library: Path, compiler: KotlinCompiler): Path {
        if (compiler.readsAnyMetadata || !PlainJar.isNeeded(library)) return library
        val plain = folder.resolve(PlainJar.name(library))
        if (!plain.exists()) PlainJar.write(library, plain)
        return plain
    }

    /** Those of [named] that are not among [ours], the libraries that every submission gets. */
    internal fun further(named: List<NamedLibrary>, ours: List<Path>): FurtherLibraries = FurtherLibraries.of(named, ours, repository)

    private fun compiler(version: String, level: String?): KotlinCompiler =
        compilers.computeIfAbsent(version) {
            val jars = repository.jars(Artifact(GROUP, COMPILER, version))
            val stdlib = repository.jar(Artifact(GROUP, "kotlin-stdlib", version))
            val jdk = System.getProperty("java.vm.version").replace(Regex("[^A-Za-z0-9.-]"), "_")
            KotlinCompiler(version, jars, stdlib, level, folder.resolve("kotlin-$version-jdk-$jdk.jsa")).also { it.warmUp() }
        }

    internal companion object {
        private const val GROUP = "org.jetbrains.kotlin"
        private const val COMPILER = "kotlin-compiler-embeddable"

        /** The version that this program itself is built with: a test keeps it so. */
        const val NEWEST = "2.4.21"

        /** Measured: 2.4.21 refuses 1.9 and older. */
        const val LOWEST_LEVEL = "2.0"

        /** The last of the old front end, for projects that name no version. */
        const val MIDDLING = "1.9.25"

        /** Of [versions] the one whose numbers differ from [wanted]'s least, the first number counting most; the newer of two. */
        fun nearest(
            wanted: String,
            versions: List<String>,
        ): String? = versions.minWithOrNull(compareBy({ abs(weight(it) - weight(wanted)) }, { -weight(it) }))

        private fun weight(version: String): Long =
            version.split('.').map { it.toLongOrNull() ?: 0 }.let { (it + listOf(0, 0, 0)).take(3) }.fold(0L) { sum, part ->
                sum * 1000 +
                    part
            }
    }
}
