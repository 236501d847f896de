package cga.imaging.tolerance

import cga.imaging.JsonNode

/** Reads the tree of a tolerance. Every mistake is a [cga.framework.InputError] that names file, place and cure. */
internal object RuleReader {
    private const val BOUND = "a number, a fraction as \"2/255\" or a percentage as \"0.2 %\", none of them negative"

    // Nobody writes so deep a tree, and a deeper one could exhaust the stack.
    private const val MAX_DEPTH = 20

    fun read(
        node: JsonNode,
        depth: Int = 0,
    ): Rule {
        if (depth > MAX_DEPTH) node.fail("is nested deeper than $MAX_DEPTH levels: write a flatter tree.")
        return when {
            "all" in node.names -> All(children(node, "all", depth))
            "any" in node.names -> AnyOf(children(node, "any", depth))
            else -> bound(node)
        }
    }

    private fun children(
        node: JsonNode,
        kind: String,
        depth: Int,
    ): List<Rule> {
        node.allowOnly(kind)
        return node.get(kind).list().map { read(it, depth + 1) }
    }

    private fun bound(node: JsonNode): Bound {
        val metric = metric(node)
        val warn = node.find("warn")?.number(BOUND, ::amount)
        val fail = node.find("fail")?.number(BOUND, ::amount)
        if (warn == null && fail == null) node.fail("bounds nothing: add \"warn\", \"fail\" or both.")
        if (warn != null && fail != null && (if (metric.higherIsBetter) warn <= fail else warn >= fail)) {
            node.fail("\"warn\" must be reached before \"fail\": exchange or correct them.")
        }
        return Bound(metric, warn, fail, node.get("reason").text(), node.get("machine").text())
    }

    private fun metric(node: JsonNode): Metric {
        val name = node.get("metric")
        val parameter =
            when (name.text()) {
                "window" -> "size"
                "flip percentile" -> "percent"
                else -> null
            }
        node.allowOnly(*listOfNotNull("metric", parameter, "warn", "fail", "reason", "machine").toTypedArray())
        return when (name.text()) {
            "max" -> Maximum
            "differing" -> Differing
            "rmse" -> Rmse
            "psnr" -> Psnr
            "window" -> WorstWindow(node.get("size").number("a whole number of pixels, at least 1", ::size))
            "flip mean" -> FlipMean
            "flip percentile" -> FlipPercentile(node.get("percent").number("a number over 0 and below 100", ::percent))
            else -> name.fail(
                "\"${name.text()}\" is no metric: use max, differing, rmse, psnr (in dB), window, flip mean or flip percentile.",
            )
        }
    }

    private fun size(text: String): Int? = text.toIntOrNull()?.takeIf { it >= 1 }

    // 0 and 100 would be the least and the greatest error, single pixels both.
    private fun percent(text: String): Double? = plain(text)?.takeIf { it > 0 && it < 100 }

    /** A bound as people write it: `0.01`, `2/255`, `0.2 %`. */
    private fun amount(text: String): Double? {
        val parts = text.split('/')
        return when {
            parts.size == 2 -> plain(parts[0])?.let { over -> plain(parts[1])?.takeIf { it > 0 }?.let { over / it } }
            text.endsWith('%') -> plain(text.dropLast(1))?.let { it / 100 }
            else -> plain(text)
        }
    }

    private fun plain(text: String): Double? =
        text.trim().takeIf { NUMBER.matches(it) }?.toDouble()?.takeIf { it.isFinite() }

    // toDouble alone would also take "NaN", "1f" and "0x1p3".
    private val NUMBER = Regex("""\d+(\.\d+)?([eE][+-]?\d+)?""")
}
