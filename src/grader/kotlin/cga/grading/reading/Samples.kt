package cga.grading.reading

import org.joml.Vector3d
import java.util.BitSet
import kotlin.math.sqrt
import kotlin.random.Random

/**
 * A vertex that a program was run at: its place in model space, and unit vectors for its other attributes of three numbers, by location.
 *
 * @property location of the attribute that the place is in.
 */
internal class SamplePoint(
    val position: Vector3d,
    val directions: Map<Int, Vector3d>,
    private val others: Attributes,
    val location: Int,
) {
    val attributes: Attributes
        get() = others + directions.mapValues { (_, d) -> doubleArrayOf(d.x, d.y, d.z, 1.0) } +
            (location to doubleArrayOf(position.x, position.y, position.z, 1.0))

    fun movedTo(place: Vector3d): SamplePoint = SamplePoint(place, directions, others, location)

    /** The same with other directions. */
    fun turned(
        how: (Int, Vector3d) -> Vector3d,
    ): SamplePoint = SamplePoint(position, directions.mapValues { (location, it) -> how(location, it) }, others, location)

    companion object {
        /** A point within [reach] of the origin along each axis, and directions all around. */
        fun random(random: Random, attributes: Map<Int, Int>, position: Int, reach: Double): SamplePoint {
            val others = attributes.keys - position
            val threes = others.filter { attributes.getValue(it) >= 3 }
            return SamplePoint(
                Vector3d(random.symmetric(reach), random.symmetric(reach), random.symmetric(reach)),
                threes.associateWith { random.direction() },
                (others - threes.toSet()).associateWith { doubleArrayOf(random.nextDouble(), random.nextDouble(), 0.0, 1.0) },
                position,
            )
        }

        fun Random.symmetric(reach: Double): Double = nextDouble(-reach, reach)

        fun Random.direction(): Vector3d {
            val z = nextDouble(-1.0, 1.0)
            val angle = nextDouble(2 * Math.PI)
            return Vector3d(sqrt(1 - z * z) * Math.cos(angle), sqrt(1 - z * z) * Math.sin(angle), z)
        }
    }
}

/** Runs at several points under the same uniforms. A number that was not computed in a run is NaN there. */
internal class Samples(
    val points: List<SamplePoint>,
    val traces: List<Trace>,
) {
    private val columns = HashMap<Long, DoubleArray>()
    private val presence = HashMap<Long, BitSet>()

    init {
        for ((i, trace) in traces.withIndex()) {
            for (node in trace.nodes) {
                columns.getOrPut(node.key) { DoubleArray(traces.size) { Double.NaN } }[i] = node.value
                presence.getOrPut(node.key, ::BitSet).set(i)
            }
        }
    }

    val size: Int get() = traces.size

    /** What [node] was in each run; what no operation made is the same in all, unless it is an attribute. */
    fun values(node: Node): DoubleArray = columns[node.key] ?: DoubleArray(size) { node.value }

    /** Whether [node] was computed in run [i]. */
    fun isPresent(node: Node, i: Int): Boolean = presence[node.key]?.get(i) == true

    fun with(more: Samples): Samples = Samples(points + more.points, traces + more.traces)

    companion object {
        /** Runs [probe] at [points]; those that come to no colour are left out. */
        fun of(probe: Probe, points: List<SamplePoint>): Samples {
            val runs = points.mapNotNull { point -> probe.at(point.attributes)?.let { point to it } }
            return Samples(runs.map { it.first }, runs.map { it.second })
        }
    }
}
