package cga.grading.submission

import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/** Models, materials and textures that a submission names, as paths below the folder it is started in. */
internal object NamedFiles {
    private val TYPES = setOf("obj", "mtl", "png", "jpg", "jpeg", "bmp", "tga", "gif", "psd", "hdr")
    private val SHADERS = setOf("glsl", "vert", "frag", "vs", "fs", "vsh", "fsh")
    private const val DEEPEST = 20
    private const val LONGEST = 300
    private const val MOST_LINES = 4_000_000L
    private const val MOST_NAMES = 200

    /**
     * What string literals of [sources] name. Without a folder it is part of a path that is put together when the program runs: that nobody
     * can read from the text.
     */
    fun inSources(sources: List<SourceFile>): List<String> =
        sources
            .flatMap { it.literals }
            .filter { it.length < LONGEST }
            .map { it.replace("\\\\", "/").replace('\\', '/') }
            .filter { '$' !in it && '/' in it && extension(it) in TYPES + SHADERS }
            .mapNotNull(::plain)
            .distinct()
            .take(MOST_NAMES)

    /** Whether [name] is of a kind that a file of ours can stand in for. A shader is the student's work. */
    fun isReplaceable(name: String): Boolean = extension(name) in TYPES

    /** What the model or the material [file], called [name], names in turn: beside itself. The ground's material is made by the program. */
    fun inModel(file: Path, name: String): List<String> {
        if (StandInAssets.isGround(name)) return emptyList()
        val isMaterial = extension(name) == "mtl"
        if (!isMaterial && extension(name) != "obj") return emptyList()
        val folder = name.substringBeforeLast('/', "")
        return words(file, if (isMaterial) "map_" else "mtllib")
            // Options stand before the name: `-s 2 2 1 file.png`.
            .map { if (isMaterial && it.startsWith("-")) it.substringAfterLast(' ') else it }
            .mapNotNull { plain("$folder/${it.replace('\\', '/')}") }
    }

    /** The names of the materials that the model [file] uses. */
    fun materials(file: Path): List<String> = words(file, "usemtl")

    private fun words(file: Path, keyword: String): List<String> =
        try {
            // Not every model is UTF-8; these lines are told by their ASCII.
            Files.lines(file, Charsets.ISO_8859_1).use { lines ->
                lines
                    .limit(MOST_LINES)
                    .filter { it.length < LONGEST && it.trimStart().startsWith(keyword) }
                    .map { it.trim().dropWhile { c -> !c.isWhitespace() }.trim() }
                    .distinct()
                    .limit(MOST_NAMES.toLong())
                    .toList()
                    .filter(String::isNotEmpty)
            }
        } catch (_: IOException) {
            emptyList()
        }

    private fun extension(name: String) = name.substringAfterLast('.', "").lowercase()

    /** [name] without `.`, null for what leads elsewhere or is no path. */
    private fun plain(name: String): String? {
        val parts = name.split('/').filter { it.isNotEmpty() && it != "." }
        val isAbsolute = name.startsWith('/') || name.getOrNull(1) == ':'
        val isSound = !isAbsolute && ".." !in parts && parts.size in 1..DEEPEST && name.length < LONGEST
        return try {
            if (isSound) parts.joinToString("/").also { Path.of(it) } else null
        } catch (_: InvalidPathException) {
            null
        }
    }
}
