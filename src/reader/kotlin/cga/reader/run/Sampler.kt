package cga.reader.run

/** A texture with the way it is looked into. */
public interface Sampler {
    /** Puts what the texture has for [look] into [result], which begins filled with 0: four numbers, or for a shadow sampler one. */
    public fun sample(look: TextureLook, result: DoubleArray)

    /** The extents of level [level] in texels, and the number of layers of an array. */
    public fun size(level: Int): IntArray

    public companion object {
        /** The same everywhere, as of a texture of one texel; a shadow sampler gives [red]. */
        public fun constant(red: Double, green: Double, blue: Double, alpha: Double): Sampler =
            object : Sampler {
                override fun sample(
                    look: TextureLook,
                    result: DoubleArray,
                ) = doubleArrayOf(red, green, blue, alpha).copyInto(result, endIndex = result.size).let { }

                override fun size(level: Int) = intArrayOf(1, 1, 1)
            }
    }
}

/** What a shader asks a texture; it is used again for the next look. */
public class TextureLook internal constructor() {
    /** Where: u, v, w as far as the texture has them, then the layer of an array; of `texelFetch` the texel. */
    public var coordinates: DoubleArray = DoubleArray(0)
        internal set

    /** Whether [coordinates] are those of a texel. */
    public var isFetch: Boolean = false
        internal set

    /** What a shadow sampler compares with, or null. */
    public var reference: Double? = null
        internal set

    /** The level that is asked for, or null. */
    public var level: Double? = null
        internal set

    /** What is added to the level that comes of the gradients. */
    public var bias: Double = 0.0
        internal set

    /**
     * How [coordinates] change from one pixel to the next, along x and along y: as the shader says, or in a [Quad] as its invocations
     * differ. Empty for a level of its own, and for a lone invocation, whose neighbours count as equal.
     */
    public var gradientX: DoubleArray = DoubleArray(0)
        internal set
    public var gradientY: DoubleArray = DoubleArray(0)
        internal set

    /** In texels, or empty. */
    public var offset: IntArray = IntArray(0)
        internal set
}
