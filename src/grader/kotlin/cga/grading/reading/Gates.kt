package cga.grading.reading

import cga.reader.shader.Operation
import org.joml.Vector3d
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.cos

/** Finds comparisons of the angle to an axis by which a branch lets a light shine or not: a cone with a hard edge. */
internal class Gates(private val samples: Samples, private val spaces: Spaces, private val axes: List<KnownVector>) {
    private val comparisons: List<Node> =
        samples.traces
            .flatMap { trace ->
                trace.nodes.filter { it.operation == Operation.LESS || it.operation == Operation.LESS_EQUAL }
            }.distinctBy { it.key }

    /** The cone that a light at the end of [way] shines in by a branch, by when its [terms] are there; null where there is none. */
    fun of(way: ToPoint, terms: List<Term>): Factor.Cone? {
        if (comparisons.isEmpty() || terms.all { it.runs.cardinality() == samples.size }) return null
        for (axis in axes) {
            val cosines = DoubleArray(samples.size) { cosine(it, way, axis) }
            for (comparison in comparisons) {
                for ((angle, edge) in listOf(comparison.operands, comparison.operands.reversed()).map { it[0] to it[1] }) {
                    val measure = Measure.entries.find { isMeasure(it, angle, cosines, axis) } ?: continue
                    if (!isSame(edge)) continue
                    val cosineOfEdge = measure.cosine(edge.value, axis.constant.length())
                    val isLitAbove = decides(terms, cosines, cosineOfEdge) ?: continue
                    return Factor
                        .Cone(way, axis, false, Falloff.HARD, if (isLitAbove) 1.0 else -1.0, cosineOfEdge, true, true, edge, measure)
                }
            }
        }
        return null
    }

    private fun cosine(i: Int, way: ToPoint, axis: KnownVector): Double =
        spaces
            .all()
            .getValue(
                way.space,
            ).transformPosition(Vector3d(samples.points[i].position))
            .sub(way.place)
            .normalize()
            .dot(Vector3d(axis.constant).normalize())

    private fun isMeasure(measure: Measure, node: Node, cosines: DoubleArray, axis: KnownVector): Boolean {
        val values = samples.values(node)
        val present = values.indices.filter { !values[it].isNaN() }
        return present.size >= FEWEST && present.all { abs(measure.cosine(values[it], axis.constant.length()) - cosines[it]) < EXACT }
    }

    private fun isSame(node: Node) = samples.values(node).filter { !it.isNaN() }.let { all -> all.isNotEmpty() && all.all { it == all[0] } }

    /** Whether [terms] are there where the cosine is above [edge], or below; null where that does not decide. */
    private fun decides(terms: List<Term>, cosines: DoubleArray, edge: Double): Boolean? {
        val lit = cosines.indices.filter { i -> terms.any { it.runs[i] } }
        return listOf(true, false).find { above ->
            lit.isNotEmpty() &&
                lit.all { abs(cosines[it] - edge) < EXACT || (cosines[it] > edge) == above }
        }
    }

    private companion object {
        const val FEWEST = 6
        const val EXACT = 1e-7
    }
}

/** What is compared to tell whether a point is in a cone; each with the cosine between the way out of the light and the axis. */
internal enum class Measure {
    /** The product of unit vectors, or with an axis that is not divided by its length. */
    COSINE,
    COSINE_OF_OPPOSITE,
    LONG_COSINE,
    LONG_COSINE_OF_OPPOSITE,
    ANGLE,
    ANGLE_OF_OPPOSITE,
    DEGREES,
    DEGREES_OF_OPPOSITE,
    ;

    /** Of [value], where the axis is [length] long. */
    fun cosine(value: Double, length: Double): Double =
        when (this) {
            COSINE -> value
            COSINE_OF_OPPOSITE -> -value
            LONG_COSINE -> value / length
            LONG_COSINE_OF_OPPOSITE -> -value / length
            ANGLE -> cos(value)
            ANGLE_OF_OPPOSITE -> -cos(value)
            DEGREES -> cos(value * PI / 180)
            DEGREES_OF_OPPOSITE -> -cos(value * PI / 180)
        }
}
