package cga.measure.accuracy.hard

/**
 * What a search found.
 *
 * @param evaluations points shaded; [compared] of them against the truth, the others only for being finite.
 * @param notFinite pixels that were NaN or infinite; [beyondBound] compared ones that were further off than floats explain.
 * @param worst the largest error of a compared one, as a share of its bound.
 * @param findings the first few of the bad ones, or the worst where there are none: what to shade to see it again.
 */
public data class SearchResult(
    public val evaluations: Int,
    public val compared: Int,
    public val notFinite: Int,
    public val beyondBound: Int,
    public val worst: Double,
    public val findings: List<String>,
)
