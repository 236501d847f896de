package cga.grading.reading

import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.cos
import kotlin.math.sin
import kotlin.random.Random

/** Runs at all angles to an axis around a place: there a cone shows as what it is, a function of the angle. */
internal class Sweeps(private val probe: Probe, private val spaces: Spaces, private val pattern: SamplePoint) {
    private class Sweep(val cosines: DoubleArray, val rows: List<Row>)

    private val made = HashMap<Pair<ToPoint, KnownVector>, Sweep?>()
    private var pairs: List<Pair<ToPoint, KnownVector>>? = null

    /** The cone that [node] is about one of [places] and one of the axes [constants]; null where it is none. */
    fun cone(node: Node, places: List<ToPoint>, constants: List<KnownVector>, samples: Samples): Factor.Cone? {
        val pairs = pairs ?: pairs(places, constants, samples).also { pairs = it }
        if (node.operation == null) return null
        val reached = reached(node)
        for ((place, axis) in pairs.filter { (_, axis) -> axis.nodes.any { it.key in reached } }) {
            val sweep = made.getOrPut(place to axis) { sweep(place, axis) } ?: continue
            of(node, place, axis, sweep)?.let { found -> listOf(found, found.long()).find { fits(it, node, samples) } }?.let { return it }
        }
        return null
    }

    /** Points in and about every cone that there may be: a narrow one is dark at nearly all points that one may try. */
    fun points(places: List<ToPoint>, constants: List<KnownVector>, samples: Samples, random: Random): List<SamplePoint> =
        pairs(places, constants, samples).flatMap { (place, axis) ->
            val back = spaces.all()[place.space]?.invert(Matrix4d()) ?: return@flatMap emptyList()
            listOf(1.0, -1.0).flatMap { sign ->
                SPREAD.map { angle ->
                    val out = around(Vector3d(axis.constant).normalize(sign), angle, random.nextDouble(2 * PI))
                    val at = Vector3d(place.place).add(out.mul(random.nextDouble(0.5, 4.0)))
                    SamplePoint.random(random, probe.attributes, pattern.location, 1.0).movedTo(back.transformPosition(at))
                }
            }
        }

    private fun around(axis: Vector3d, angle: Double, turn: Double): Vector3d {
        val side = (if (abs(axis.x) < 0.9) Vector3d(1.0, 0.0, 0.0) else Vector3d(0.0, 1.0, 0.0)).orthogonalizeUnit(axis)
        val up = Vector3d(axis).cross(side)
        return Vector3d(axis).mul(cos(angle)).add(side.mul(sin(angle) * cos(turn))).add(up.mul(sin(angle) * sin(turn)))
    }

    /** The keys of all that [node] is made of. */
    private fun reached(node: Node): Set<Long> {
        val seen = HashSet<Long>()
        val open = ArrayDeque(listOf(node))
        while (open.isNotEmpty()) {
            val next = open.removeLast()
            if (seen.add(next.key)) open += next.operands
        }
        return seen
    }

    /** Ways and axes of which the shader computes the product. */
    private fun pairs(places: List<ToPoint>, constants: List<KnownVector>, samples: Samples): List<Pair<ToPoint, KnownVector>> {
        val index = samples.traces[0].nodes.filter { it.operation != null }.groupBy { rounded(abs(it.value)) }
        return places.flatMap { place -> constants.map { place to it } }.filter { (place, axis) -> isComputed(place, axis, samples, index) }
    }

    private fun isComputed(place: ToPoint, axis: KnownVector, samples: Samples, index: Map<Long, List<Node>>): Boolean {
        val lengths = listOf(1.0, axis.constant.length()).distinct()
        for (isUnit in listOf(true, false)) {
            for (length in lengths) {
                val products = DoubleArray(samples.size) { product(samples.points[it].position, place, axis.constant, isUnit) / length }
                val near = rounded(abs(products[0])).let { r -> listOf(r - 1, r, r + 1) }.flatMap { index[it].orEmpty() }
                val isThere = near.any { node ->
                    val values = samples.values(node)
                    values.indices.all { abs(abs(values[it]) - abs(products[it])) < 1e-8 * (1 + abs(products[it])) || values[it].isNaN() }
                }
                if (isThere) return true
            }
        }
        return false
    }

    private fun product(point: Vector3dc, place: ToPoint, axis: Vector3dc, isUnit: Boolean): Double {
        val way = spaces.all().getValue(place.space).transformPosition(Vector3d(point)).sub(place.place)
        return (if (isUnit) way.normalize() else way).dot(axis)
    }

    private fun rounded(x: Double) = Math.round(x * 1e7)

    /** The shape of [node], which is known to be a cone about [axis], with the numbers that the probe has now. */
    fun shape(node: Node, place: ToPoint, axis: KnownVector): Factor.Cone? = sweep(place, axis)?.let { of(node, place, axis, it) }

    private fun sweep(place: ToPoint, axis: KnownVector): Sweep? {
        val matrix = spaces.all()[place.space] ?: return null
        val back = matrix.invert(Matrix4d())
        // The light's way out, along which θ is 0.
        val direction = Vector3d(axis.constant).normalize()
        val points = ANGLES.map {
            pattern.movedTo(
                back.transformPosition(Vector3d(place.place).add(around(direction, it, 0.0).mul(REACH))),
            )
        }
        val runs = points.mapNotNull { point -> probe.rowAt(point.attributes)?.let { cosine(point.position, place, direction) to it } }
        if (runs.size < ANGLES.size / 2) return null
        return Sweep(DoubleArray(runs.size) { runs[it].first }, runs.map { it.second })
    }

    /** Of the angle between [axis] and the way from the light to [point]. */
    private fun cosine(point: Vector3dc, place: ToPoint, axis: Vector3dc): Double {
        val surface = spaces.all().getValue(place.space).transformPosition(Vector3d(point))
        return surface.sub(place.place).normalize().dot(axis)
    }

    private fun of(node: Node, place: ToPoint, axis: KnownVector, sweep: Sweep): Factor.Cone? {
        val values = DoubleArray(sweep.rows.size) { sweep.rows[it][node.key] }
        val present = values.indices.filter { values[it].isFinite() }
        if (present.size < 6) return null
        val c = present.map { sweep.cosines[it] }
        val f = present.map { values[it] }
        if (f.max() - f.min() < 1e-6) return null

        fun cone(falloff: Falloff, slope: Double, offset: Double, below: Boolean, above: Boolean) =
            Factor.Cone(place, axis, abs(axis.constant.length() - 1) < 1e-6, falloff, slope, offset, below, above, node)
        for (falloff in listOf(Falloff.LINEAR, Falloff.IN_ANGLE, Falloff.SMOOTH)) {
            val x = c.map { if (falloff == Falloff.IN_ANGLE) acos(it.coerceIn(-1.0, 1.0)) else it }
            val line = line(x, f, falloff) ?: continue
            for ((below, above) in LIMITS) {
                val isAll = x.indices.all {
                    abs(shape(line.first * x[it] + line.second, below, above, falloff) - f[it]) <
                        1e-7 * (1 + abs(f[it]))
                }
                if (isAll) return cone(falloff, line.first, line.second, below, above)
            }
        }
        if (f.all { it == 0.0 || it == 1.0 }) {
            val edge =
                f.zip(c).zipWithNext().find { (a, b) -> a.first != b.first }?.let { (a, b) -> (a.second + b.second) / 2 } ?: return null
            return cone(Falloff.HARD, if (f.first() == 1.0) 1.0 else -1.0, edge, below = true, above = true)
        }
        return null
    }

    /** The straight line between 0 and 1, by two of its points: slope and offset. */
    private fun line(x: List<Double>, f: List<Double>, falloff: Falloff): Pair<Double, Double>? {
        val inside = f.indices.filter { f[it] > 1e-9 && f[it] < 1 - 1e-9 }
        val use = if (inside.size >= 2) inside else f.indices.filter { abs(f[it]) > 1e-9 && abs(f[it] - 1) > 1e-9 }
        if (use.size < 2) return null
        val (i, j) = use.first() to use.last()
        val (a, b) = listOf(f[i], f[j]).map { if (falloff == Falloff.SMOOTH) straightened(it) ?: return null else it }
        val slope = (b - a) / (x[j] - x[i])
        return if (slope.isFinite()) slope to a - slope * x[i] else null
    }

    /** The t with 3t² − 2t³ = [s]. */
    private fun straightened(s: Double): Double? = if (s in 0.0..1.0) 0.5 - sin(Math.asin(1 - 2 * s) / 3) else null

    private fun shape(t: Double, below: Boolean, above: Boolean, falloff: Falloff): Double {
        val low = if (below) maxOf(t, 0.0) else t
        val high = if (above) minOf(low, 1.0) else low
        return if (falloff == Falloff.SMOOTH) high * high * (3 - 2 * high) else high
    }

    /** Whether [cone] says what [node] is at all [samples], too. */
    private fun fits(cone: Factor.Cone, node: Node, samples: Samples): Boolean {
        val values = samples.values(node)
        val direction = Vector3d(cone.axis.constant).normalize()
        return values.indices.filter { samples.isPresent(node, it) && values[it].isFinite() }.all { i ->
            // With a vector of full length it is the distance of the sweep at which the numbers are those of the shape.
            val length = if (cone.isLong) {
                spaces
                    .all()
                    .getValue(
                        cone.way.space,
                    ).transformPosition(Vector3d(samples.points[i].position))
                    .distance(Vector3d(cone.way.place)) /
                    REACH
            } else {
                1.0
            }
            val cosine = length * cosine(samples.points[i].position, cone.way, direction)
            val x = if (cone.falloff == Falloff.IN_ANGLE) acos(cosine) else cosine
            when (cone.falloff) {
                Falloff.HARD -> (cone.slope * (cosine - cone.offset) > 0) == (values[i] == 1.0) || abs(cosine - cone.offset) < 0.03
                else ->
                    abs(shape(cone.slope * x + cone.offset, cone.isLimitedBelow, cone.isLimitedAbove, cone.falloff) - values[i]) <
                        1e-7 * (1 + abs(values[i]))
            }
        }
    }

    private companion object {
        const val REACH = 2.0

        /** Finer near the axis, where cones end. */
        val ANGLES = (
            (1..10).map {
                it * 0.4
            } + (5..60).map { it.toDouble() } + (63..179 step 4).map { it.toDouble() }
        ).map { it * PI / 180 }

        /** From the axis to a right angle, close to it at first. */
        val SPREAD = listOf(0.3, 1.0, 2.0, 4.0, 8.0, 12.0, 16.0, 20.0, 25.0, 32.0, 45.0, 70.0).map { it * PI / 180 }

        /** What is limited: below, above. The right one first. */
        val LIMITS = listOf(true to true, true to false, false to true, false to false)
    }
}
