package cga.measure.accuracy

/**
 * How far one implementation of one operation is from the truth, over all cases of a kind.
 *
 * @param options JOML's system properties in force, "" for none.
 * @param cases how many; [notFinite] of them had a NaN or an infinity and are not in the numbers below, which are NaN without any.
 * @param maxUlp largest error of a number, in ulps of a float of the largest number in its column ([Errors] says why); [meanUlp]
 * the mean.
 * @param maxRelative largest error of a number, as a share of the largest number in its matrix.
 */
public data class Figure(
    public val operation: Operation,
    public val kind: String,
    public val implementation: String,
    public val options: String,
    public val cases: Int,
    public val notFinite: Int,
    public val maxUlp: Double,
    public val meanUlp: Double,
    public val maxRelative: Double,
) {
    /** One line of CSV, with [HEADER]'s columns. No text in it holds a comma. */
    public fun toCsv(): String =
        listOf(operation.label, kind, implementation, options, cases, notFinite, maxUlp, meanUlp, maxRelative).joinToString(",")

    public companion object {
        public const val HEADER: String = "operation,kind,implementation,options,cases,not_finite,max_ulp,mean_ulp,max_relative"

        internal fun ofCsv(line: String): Figure {
            val c = line.split(',')
            val operation = Operation.of(c[0])
            return Figure(operation, c[1], c[2], c[3], c[4].toInt(), c[5].toInt(), c[6].toDouble(), c[7].toDouble(), c[8].toDouble())
        }
    }
}
