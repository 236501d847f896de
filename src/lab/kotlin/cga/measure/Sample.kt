package cga.measure

/** Measurements of one quantity, in its unit. */
public class Sample(values: List<Double>) {
    private val sorted = values.sorted()

    public val median: Double = sorted[sorted.size / 2]
    public val lowest: Double = sorted.first()
    public val highest: Double = sorted.last()

    /** As if each of [parts] equal parts had taken its share. */
    public operator fun div(parts: Int): Sample = Sample(sorted.map { it / parts })
}
