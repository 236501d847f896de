package cga.reference

import cga.framework.Frame

/** All triangles of a frame under one numbering: those of the first draw in their order, then those of the second, and so on. */
public class Triangles(
    frame: Frame,
    width: Int,
    height: Int,
) {
    private val draws = frame.draws.map { Vertices(frame, it, width, height) }
    private val first = draws.runningFold(0) { number, vertices -> number + vertices.draw.indices.size / 3 }.toIntArray()
    private val drawOf = IntArray(first.last())

    /** How many there are. */
    public val count: Int get() = first.last()

    init {
        for (draw in draws.indices) drawOf.fill(draw, first[draw], first[draw + 1])
    }

    /** The draw that triangle [number] belongs to. */
    public fun draw(number: Int): Int = drawOf[number]

    /** Its number in that draw. */
    public fun numberInDraw(number: Int): Int = number - first[drawOf[number]]

    /** The vertices of its draw. */
    public fun vertices(number: Int): Vertices = draws[drawOf[number]]

    /** Which of the draw's vertices is its corner 0, 1 or 2. */
    public fun corner(
        number: Int,
        corner: Int,
    ): Int = draws[drawOf[number]].draw.indices[3 * numberInDraw(number) + corner]
}
