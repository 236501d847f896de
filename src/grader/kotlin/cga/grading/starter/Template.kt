package cga.grading.starter

import cga.framework.InputError

/**
 * A source file of the solution, read as what it leaves to students.
 *
 * Markers are comments, alone on their lines, in Kotlin and GLSL alike:
 *
 *     // solution 4.2.1: send the colour      becomes  // TODO 4.2.1: send the colour
 *     // Lösung 4.2.1: Senden Sie die Farbe   is the same for those who are spoken to in German
 *     // instead: return 0                    becomes  return 0
 *     …                                       is removed
 *     // end of solution                      is removed
 *
 * A lone `// solution` leaves nothing, and a file of which nothing is left is none of the starter's. Regions do not lie within each other.
 *
 * @param solution the file as it is, markers and all.
 * @param name of the file, for errors. Throws [InputError] naming it and the line of a marker that does not fit.
 */
public class Template(
    private val name: String,
    public val solution: String,
    private val language: StarterLanguage = StarterLanguage.ENGLISH,
) {
    private val kept = ArrayList<String>()
    private val cut = ArrayList<Region>()

    /** What was cut out, from top to bottom. */
    public val regions: List<Region> get() = cut

    /** The file as students get it. */
    public val starter: String

    init {
        val lines = solution.split('\n')
        var at = 0
        while (at < lines.size) at = if (START.matches(lines[at])) cutRegion(lines, at) else keep(lines, at)
        starter = kept.joinToString("\n")
    }

    private fun keep(
        lines: List<String>,
        at: Int,
    ): Int {
        if (END.matches(lines[at]) || INSTEAD.matches(lines[at])) throw misplaced(at, "it belongs to no solution")
        kept += lines[at]
        return at + 1
    }

    /** Cuts the region out that begins at [start] and returns where the file goes on. */
    private fun cutRegion(
        lines: List<String>,
        start: Int,
    ): Int {
        val line = kept.size
        var at = start
        while (at < lines.size) {
            val todo = START.matchEntire(lines[at]) ?: break
            val isOurs = todo.groupValues[2] == if (language == StarterLanguage.GERMAN) "Lösung" else "solution"
            if (isOurs && todo.groupValues[3].isNotEmpty()) kept += todo.groupValues[1] + "// TODO " + todo.groupValues[3]
            at++
        }
        while (at < lines.size) {
            val code = INSTEAD.matchEntire(lines[at]) ?: break
            kept += code.groupValues[1] + code.groupValues[2]
            at++
        }
        while (at < lines.size && !END.matches(lines[at])) {
            if (START.matches(lines[at]) || INSTEAD.matches(lines[at])) throw misplaced(at, "it lies within a solution")
            at++
        }
        if (at == lines.size) throw misplaced(start, "it has no // end of solution")
        cut += Region(line, lines.subList(start, at + 1), kept.subList(line, kept.size).toList())
        return at + 1
    }

    private fun misplaced(
        at: Int,
        reason: String,
    ) = InputError("$name:${at + 1}: this marker is wrong, $reason: correct it.")

    /** The way back, which shows that nothing else was lost. */
    public companion object {
        private val START = Regex("""( *)// (solution|Lösung)(?: (\d\.\d.*))?""")
        private val INSTEAD = Regex("""( *)// instead: (.*)""")
        private val END = Regex(""" *// end of solution""")

        /** The solution that [starter] was before [regions] were cut out of it. Throws [IllegalArgumentException] where one does not fit. */
        public fun solution(
            starter: String,
            regions: List<Region>,
        ): String {
            val lines = starter.split('\n').toMutableList()
            for (region in regions.sortedByDescending { it.line }) {
                val there = lines.subList(region.line, region.line + region.left.size)
                require(there == region.left) { "line ${region.line + 1} is not where a solution was cut out: $there" }
                there.clear()
                lines.addAll(region.line, region.removed)
            }
            return lines.joinToString("\n")
        }
    }
}
