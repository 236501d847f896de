package cga.grading.starter

/**
 * A part of the solution that a student writes.
 *
 * @param line where it was cut out: index of the first of [left] among the starter's lines.
 * @param removed lines of the solution, with their markers.
 * @param left lines of the starter in their place: what is to do, and code that is needed until it is done. May be empty.
 */
public class Region(
    public val line: Int,
    public val removed: List<String>,
    public val left: List<String>,
)
