package cga.imaging

/** What there is to say in numbers of two pictures that differ, as name and value. */
public fun figures(comparison: Comparison): List<Pair<String, String>> {
    val (difference, flip) = comparison.difference to comparison.flip
    val window = comparison.worstWindow(Comparison.WINDOW)
    return listOf(
        "Pixels that differ" to "${grouped(difference.differing)} of ${grouped(difference.pixels)} (${percent(difference.fraction)})",
        "Largest difference" to
            difference.maximum.withIndex().joinToString(" · ") { (i, value) -> "${CHANNEL_NAMES[i]} ${step(value, comparison.expected)}" },
        "RMSE" to
            brief(difference.rmse) + if (comparison.expected is BytePicture) " (${step(difference.rmse, comparison.expected)})" else "",
        "PSNR" to "${brief(difference.psnr)} dB",
        "Worst ${window.size}×${window.size} window" to
            "mean ${step(window.error, comparison.expected)}, at ${window.corner.x}, ${window.corner.y}",
        "ꟻLIP mean" to brief(flip.mean),
        "ꟻLIP percentiles" to PERCENTILES.joinToString(" · ") { "$it\u00A0%:\u00A0${brief(flip.percentile(it / 100.0).toDouble())}" },
        "ꟻLIP maximum" to brief(flip.error.max().toDouble()),
    )
}

private val PERCENTILES = listOf(50, 90, 95, 99)
