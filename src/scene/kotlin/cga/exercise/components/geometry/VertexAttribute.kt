package cga.exercise.components.geometry

/**
 * Where one attribute lies in a vertex.
 *
 * @param n number of floats (1 to 4).
 * @param stride bytes from one vertex to the next.
 * @param offset bytes from the vertex's start to the attribute.
 */
public class VertexAttribute(
    public val n: Int,
    public val stride: Int,
    public val offset: Int,
)
