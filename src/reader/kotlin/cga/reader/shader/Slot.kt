package cga.reader.shader

/** The kinds of numbers of GLSL. A sampler is one of a machine's textures; a boolean in a block counts as [UINT]. */
public enum class Kind { FLOAT, INT, UINT, BOOL, SAMPLER }

/**
 * A uniform, input or output of a basic type, by the name that OpenGL has for it: `lights[2].color`.
 *
 * @property columns of a matrix, otherwise 1.
 * @property rows of a matrix or vector, otherwise 1.
 * @property location what `layout(location = …)` or the compiler says of the variable that it belongs to, null for GLSL's own.
 */
public class Slot internal constructor(
    public val name: String,
    public val kind: Kind,
    public val columns: Int,
    public val rows: Int,
    public val location: Int?,
    internal val cell: Int,
) {
    /** How many numbers it has. */
    public val size: Int get() = columns * rows

    override fun toString(): String = name
}
