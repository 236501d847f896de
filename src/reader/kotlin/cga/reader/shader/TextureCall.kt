package cga.reader.shader

/** A look into a texture: the cells of what it is asked with, each list empty where that part is not given. */
internal class TextureCall(
    val sampler: Int,
    val coordinates: IntArray,
    val isFetch: Boolean,
    val isShadow: Boolean,
    val reference: Int,
    val bias: Int,
    val lod: Int,
    val gradientX: IntArray,
    val gradientY: IntArray,
    val offset: IntArray,
    val results: Int,
) {
    val isImplicit: Boolean get() = lod < 0 && gradientX.isEmpty() && !isFetch

    /** Every cell that it reads, the sampler first. */
    val operands: IntArray =
        intArrayOf(sampler) + coordinates + intArrayOf(reference, bias, lod).filter { it >= 0 } + gradientX + gradientY + offset
}

/** Where a `switch` goes on for which number. */
internal class SwitchTable(
    val targets: Map<Int, Int>,
    val default: Int,
)
