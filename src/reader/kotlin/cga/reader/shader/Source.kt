package cga.reader.shader

/** Where a number comes from that no operation has made. */
public sealed interface Source {
    /** Written into the shader, or made of such numbers by the compiler. */
    public data class Constant(val value: Double) : Source

    /** Component [component] of a uniform, column by column. */
    public data class Uniform(val slot: Slot, val component: Int) : Source

    /** Component [component] of an input: an attribute or a varying, or one of GLSL's own as `gl_FragCoord`. */
    public data class Input(val slot: Slot, val component: Int) : Source

    /** A variable that nothing was assigned to yet; it reads as 0. */
    public data class Unset(val variable: String) : Source
}
