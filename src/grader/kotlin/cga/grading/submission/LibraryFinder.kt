package cga.grading.submission

import cga.grading.prepared.NamedLibrary
import cga.grading.prepared.PreparedTree

/** Reads which libraries build files name for the program itself, not for its tests. */
internal object LibraryFinder {
    /** More than that no game needs. */
    private const val MOST = 40
    private const val WORD = """["']([\w.-]+)["']"""
    private const val USE = """\b(?:implementation|api|compile|runtimeOnly)\b\s*+\(?+\s*+"""

    /** A file of the project's own is in no repository. */
    private const val NOT_BESIDE = """(?!\s*+<scope>system)"""

    /** Each with the group, the name and, where there is one, the version. */
    private val SHAPES = listOf(
        USE + """["']([\w.-]+):([\w.-]+):?([^"':@]*)""",
        """$USE$WORD\s*+,\s*+$WORD(?:\s*+,\s*+["']?([^"'),\s]+))?""",
        USE + """group\s*+[:=]\s*+$WORD\s*+,\s*+name\s*+[:=]\s*+$WORD(?:\s*+,\s*+version\s*+[:=]\s*+["']([^"']+))?""",
        """\bmodule\s*+=\s*+["']([\w.-]+):([\w.-]+)["'](?:\s*+,\s*+version(?:\.ref)?\s*+=\s*+["']([^"']+))?""",
        """<dependency>\s*+<groupId>([^<]+)</groupId>\s*+<artifactId>([^<]+)</artifactId>(?:\s*+<version>([^<]+)</version>)?+$NOT_BESIDE""",
    ).map { Regex(it) }

    /** A module of LWJGL, which stands in lists of such names. */
    private val MODULE = Regex("""["'](lwjgl-(?!bom)[a-z0-9]+)["']""")
    private const val LWJGL = "org.lwjgl"

    /** What [texts] (build files by path, without comments) name. No build script is run: this is only reading. */
    fun find(texts: Collection<String>): List<NamedLibrary> {
        val written = texts.flatMap { text -> SHAPES.flatMap { it.findAll(text) } }.map { it.groupValues.drop(1) }
        val modules = texts.flatMap { MODULE.findAll(it) }.map { listOf(LWJGL, it.groupValues[1], "") }
        return (written + modules)
            .distinctBy { it.take(2) }
            .take(MOST)
            .map { (group, name, said) ->
                NamedLibrary(group, name, version(said.trim(), texts))
            }.filter { listOfNotNull(it.group, it.name, it.version).all(PreparedTree::isCoordinate) }
    }

    /** The number that [said] is, or that the variable of that name has. */
    private fun version(said: String, texts: Collection<String>): String? {
        val name = said.trim('$', '{', '}').ifEmpty { return null }
        if (name[0].isDigit()) return name
        return listOf(name, name.substringAfterLast('.')).firstNotNullOfOrNull { variable ->
            val value = Regex("""\b${Regex.escape(variable)}["']?\s*+(?:=|>|,|\bby extra\()\s*+["']?(\d[\w.+-]*)""")
            texts.firstNotNullOfOrNull { value.find(it)?.groupValues?.get(1) }
        }
    }
}
