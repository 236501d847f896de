package cga.grading.reading

import org.joml.Vector3dc

/** How a cosine is kept from being negative. */
internal enum class Clamp { NONE, ZERO, ZERO_TO_ONE, ABSOLUTE }

/** A vector as it is used in a product: divided by its length or not, with its sign. */
internal data class Use(val vector: KnownVector, val isUnit: Boolean, val sign: Double)

/** A way from the surface to a point, as it is used. */
internal data class WayUse(val way: ToPoint, val isUnit: Boolean, val sign: Double)

/** Which vectors a highlight's cosine is between. */
internal enum class Lobe {
    /** n and (l + v)/|l + v|. */
    HALF,

    /** n and l + v, which may be as long as 2. */
    HALF_RAW,

    /** n and (l + v)/2. */
    HALF_MEAN,

    /** v and l mirrored at n. */
    REFLECTED,
}

/** How a spotlight fades from its inner to its outer angle, as a function of cos θ. */
internal enum class Falloff {
    /** In a straight line, as the sheet has it. */
    LINEAR,
    IN_ANGLE,
    SMOOTH,
    POWER,
    HARD,
    OTHER,
}

/** A factor of a term of the picture that is the same for red, green and blue; [line] is where it is computed. */
internal sealed interface Factor {
    val node: Node
    val line: ShaderLine get() = node.line

    /** cos α = n · l. */
    class Cosine(val normal: Use, val light: WayUse, val clamp: Clamp, override val node: Node) : Factor

    /** cos β to a power. */
    class Highlight(
        val lobe: Lobe,
        val normal: Use,
        val light: WayUse,
        val eye: WayUse,
        val exponent: Double,
        val exponentFrom: Node?,
        val isClamped: Boolean,
        override val node: Node,
    ) : Factor

    /**
     * 1 / (k₀ + k₁·d + k₂·d²), or where it [isDivided] not that sum itself.
     *
     * @property isNodeSum whether [node] is the sum and not its inverse.
     */
    class Fade(
        val way: ToPoint,
        val k: Vector3dc,
        val isDivided: Boolean,
        override val node: Node,
        val isNodeSum: Boolean,
    ) : Factor

    /**
     * A spotlight's intensity: [slope]·cos θ + [offset], limited to at least 0 and at most 1 where it is.
     *
     * @property isLong whether the vector to the light is not divided by its length, so that the cone is the wider the farther it reaches.
     * @property comparedAs what is compared with [node], where a branch decides by that; [offset] is the cosine of the edge then.
     */
    class Cone(
        val way: ToPoint,
        val axis: KnownVector,
        val isAxisUnit: Boolean,
        val falloff: Falloff,
        val slope: Double,
        val offset: Double,
        val isLimitedBelow: Boolean,
        val isLimitedAbove: Boolean,
        override val node: Node,
        val comparedAs: Measure? = null,
        val isLong: Boolean = false,
    ) : Factor {
        /** The same about a vector to the light that has its full length. */
        fun long(): Cone =
            Cone(way, axis, isAxisUnit, falloff, slope, offset, isLimitedBelow, isLimitedAbove, node, comparedAs, isLong = true)
    }

    /** The same number everywhere. */
    class Scale(override val node: Node) : Factor

    /** A function of the normal's direction alone: a sun, a sky. */
    class Aside(override val node: Node) : Factor

    /** What is none of these. */
    class Unknown(override val node: Node) : Factor
}
