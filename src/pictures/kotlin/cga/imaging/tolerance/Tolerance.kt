package cga.imaging.tolerance

import cga.framework.InputError
import cga.imaging.BytePicture
import cga.imaging.Comparison
import cga.imaging.FloatPicture
import cga.imaging.JsonNode
import java.nio.file.Path

/**
 * How far two pictures may differ: one tree of bounds for 8-bit pictures and one for float pictures, whose differences have other
 * units and sizes. A file holds one,
 *
 *     { "byte": RULE, "float": RULE }
 *
 * or several that have names ([ToleranceTiers]). Either tree may be left away. A `RULE` is `{"all": [RULE, …]}`, `{"any": [RULE, …]}` or
 *
 *     { "metric": "max", "warn": "1/255", "fail": "2/255", "reason": "why", "machine": "measured on" }
 *
 * with the metrics `max` (largest difference), `differing` (share of pixels), `rmse`, `psnr` (dB, the only one where more is better),
 * `window` (with `"size": N`: mean difference in the worst N×N pixels), `flip mean` and `flip percentile` (with `"percent": P`).
 * A value that equals its bound is within it.
 */
public class Tolerance internal constructor(
    public val name: String,
    private val byteRule: Rule?,
    private val floatRule: Rule?,
) {
    /**
     * Equal pictures pass with nothing computed, others by the tree.
     * Throws [InputError] where the tolerance has no tree for pictures of this kind.
     */
    public fun judge(comparison: Comparison): Verdict {
        if (comparison.isIdentical) return Verdict.PASS
        val (rule, kind) =
            when (comparison.expected) {
                is BytePicture -> byteRule to "byte"
                is FloatPicture -> floatRule to "float"
            }
        return rule?.judge(comparison) ?: throw InputError("the tolerance $name has no bounds for $kind pictures: add \"$kind\" to it.")
    }

    public companion object {
        /**
         * The tolerance in the file at [path], the one called [tier] where it holds several.
         * Throws [InputError] naming the file, the place in it and the cure.
         */
        public fun read(
            path: Path,
            tier: String? = null,
        ): Tolerance {
            val node = JsonNode.read(path, "tolerance")
            if ("tiers" in node.names) return ToleranceTiers.of(node).named(tier)
            if (tier != null) node.fail("holds one tolerance without a name, not \"$tier\": name none.")
            node.allowOnly("byte", "float", "tiers")
            return of(node, "$path")
        }

        internal fun of(
            node: JsonNode,
            name: String,
        ): Tolerance {
            val (byte, float) = listOf("byte", "float").map { kind -> node.find(kind)?.let { RuleReader.read(it) } }
            if (byte == null && float == null) node.fail("bounds nothing: add \"byte\", \"float\" or both.")
            return Tolerance(name, byte, float)
        }
    }
}
