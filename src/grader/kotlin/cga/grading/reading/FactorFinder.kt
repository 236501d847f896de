package cga.grading.reading

import cga.reader.shader.Operation
import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.max
import kotlin.math.pow

/**
 * Tells by its values at all samples what a number is: the cosine of which angle, faded with which distance, limited to which cone.
 *
 * @param eye where the camera is, in each space.
 */
internal class FactorFinder(
    private val samples: Samples,
    private val finder: VectorFinder,
    vectors: List<KnownVector>,
    private val spaces: Spaces,
    private val sweeps: Sweeps,
) {
    private val known = HashMap<Long, Factor?>()
    private val places =
        places(vectors, spaces) +
            if (hasDistances()) waysTo(constants(vectors).filter { it.nodes[0].source != null }, spaces) else emptyList()
    private val normals = vectors.filter { it.dependsOnNormal }
    private val constants = constants(vectors)

    private fun hasDistances() = samples.traces[0].nodes.any { it.origin == "distance" }

    /** Those from which the camera is seen. */
    val eyes: List<ToPoint> = places.filter(::isEye)

    private fun isEye(way: ToPoint): Boolean =
        Vector3d(way.place).distance(eye(way.space) ?: return false) < NEAR * (1 + way.place.length())

    private fun eye(space: Space): Vector3d? =
        when (space) {
            Space.VIEW -> Vector3d()
            Space.WORLD -> spaces.view?.invert(org.joml.Matrix4d())?.transformPosition(Vector3d())
            Space.MODEL -> spaces.modelView.invert(org.joml.Matrix4d()).transformPosition(Vector3d())
        }

    /** What [node] is; null where it is nothing that is known. */
    fun of(node: Node): Factor? = known.getOrPut(node.key) { find(node) }

    private fun find(node: Node): Factor? {
        val values = samples.values(node)
        val present = values.indices.filter { samples.isPresent(node, it) }
        if (present.size < FEWEST) return null
        val first = values[present[0]]
        val isSame = present.all { abs(values[it] - first) <= EXACT * abs(first) }
        if (node.operation == null && isSame) return Factor.Scale(node)
        // A narrow cone may be 0 wherever it was looked at.
        sweeps.cone(node, places, constants, samples)?.let { return it }
        if (isSame) return Factor.Scale(node)
        return cosine(node, values, present) ?: aside(node, values, present) ?: fade(node, values, present)
            ?: highlight(node, values, present)
    }

    private val wayValues = HashMap<Pair<ToPoint, Boolean>, List<Vector3d>>()
    private val normalValues = HashMap<Use, List<Vector3d>>()

    private fun way(i: Int, way: ToPoint, isUnit: Boolean): Vector3d =
        wayValues.getOrPut(way to isUnit) {
            samples.points.map { way.vector.at(it.position, finder.normalOf(it), isUnit).mul(way.sign) }
        }[i]

    private fun normal(i: Int, use: Use): Vector3d =
        normalValues.getOrPut(use) { samples.points.map { use.vector.at(it.position, finder.normalOf(it), use.isUnit).mul(use.sign) } }[i]

    private fun normalUses() = normals.flatMap { n -> listOf(true, false).map { Use(n, it, 1.0) } }

    private fun cosine(node: Node, values: DoubleArray, present: List<Int>): Factor? {
        for (n in normalUses()) {
            val normal = present.map { normal(it, n) }
            for (place in places) {
                for (isUnit in listOf(true, false)) {
                    for (sign in SIGNS) {
                        val clamp = Clamp.entries.find { clamp ->
                            present.all { near(values[it], clamped(sign * normal(it, n).dot(way(it, place, isUnit)), clamp)) }
                        } ?: continue
                        return Factor.Cosine(n, WayUse(place, isUnit, sign), clamp, node)
                    }
                }
            }
        }
        return null
    }

    private fun clamped(x: Double, clamp: Clamp) =
        when (clamp) {
            Clamp.NONE -> x
            Clamp.ZERO -> max(x, 0.0)
            Clamp.ZERO_TO_ONE -> x.coerceIn(0.0, 1.0)
            Clamp.ABSOLUTE -> abs(x)
        }

    private fun near(a: Double, b: Double) = abs(a - b) <= EXACT * (1 + abs(b))

    /** What is affine in the normal's direction wherever it is not limited to 0 or more. */
    private fun aside(node: Node, values: DoubleArray, present: List<Int>): Factor? {
        for (n in normals) {
            val lit = present.filter { values[it] != 0.0 }
            if (lit.size < 2 * FEWEST) return null
            val rows = lit.map { i -> normal(i, Use(n, true, 1.0)).let { doubleArrayOf(1.0, it.x, it.y, it.z) } }
            if (LeastSquares(rows).solve(DoubleArray(lit.size) { values[lit[it]] }) != null) return Factor.Aside(node)
        }
        return null
    }

    private fun fade(node: Node, values: DoubleArray, present: List<Int>): Factor? {
        for (place in places) {
            val lengths = present.map { way(it, place, false).length() }
            val solver = LeastSquares(lengths.map { doubleArrayOf(1.0, it, it * it) })
            for (isDivided in listOf(true, false)) {
                val numbers = DoubleArray(present.size) { values[present[it]].let { f -> if (isDivided) 1 / f else f } }
                if (numbers.any { !it.isFinite() }) continue
                val k = solver.solve(numbers) ?: continue
                return Factor.Fade(place, Vector3d(k[0], k[1], k[2]), isDivided, node, !isDivided)
            }
        }
        return null
    }

    private fun highlight(node: Node, values: DoubleArray, present: List<Int>): Factor? {
        // A cosine to a power is positive where the cosine is; where that is negative it is 0, or nothing.
        val some = present.filter { it < FIRST }
        val lit = some.filter { values[it] > 1e-290 && values[it].isFinite() }
        if (lit.size < FEWEST) return null
        for (angle in angles) {
            val exponent = exponent(lit, values, angle.cosines) ?: continue
            val isClamped = some.filter { it !in lit }.all { i ->
                values[i] == 0.0 ||
                    angle.cosines[i].let { it > 0 && it.pow(exponent) < 1e-280 }
            }
            return Factor.Highlight(
                angle.lobe, angle.normal, angle.light, angle.eye, exponent,
                exponentNode(
                    node,
                    exponent,
                ),
                isClamped, node,
            )
        }
        return null
    }

    private fun exponent(lit: List<Int>, values: DoubleArray, cosines: DoubleArray): Double? {
        var exponent = Double.NaN
        for (i in lit) {
            val c = cosines[i]
            if (c <= 0) return null
            if (abs(c - 1) < 1e-3) continue
            val k = ln(values[i]) / ln(c)
            if (exponent.isNaN()) exponent = k
            if (!(abs(k - exponent) <= 1e-6 * abs(exponent))) return null
        }
        return exponent.takeIf { it > 0 }
    }

    /** A cosine that a highlight may be of, at every sample. */
    private class Angle(val lobe: Lobe, val normal: Use, val light: WayUse, val eye: WayUse, val cosines: DoubleArray)

    /** All of them, the right one of each light first. Where no vector leads to the camera, any may be meant for that. */
    private val angles: List<Angle> by lazy {
        val others = places.filter { !isEye(it) }
        val seen = eyes.ifEmpty { others }
        VARIANTS.flatMap { variant ->
            normalUses().flatMap { n -> others.flatMap { l -> seen.filter { it !== l }.map { v -> angle(variant, n, l, v) } } }
        }
    }

    private fun angle(variant: Variant, n: Use, l: ToPoint, v: ToPoint): Angle {
        val cosines = DoubleArray(minOf(samples.size, FIRST)) { i ->
            val normal = normal(i, n)
            val light = Vector3d(way(i, l, variant.lightUnit)).mul(variant.lightSign)
            val eye = Vector3d(way(i, v, variant.eyeUnit)).mul(variant.eyeSign)
            when (variant.lobe) {
                Lobe.HALF -> light.add(eye).normalize().dot(normal)
                Lobe.HALF_RAW -> light.add(eye).dot(normal)
                Lobe.HALF_MEAN -> light.add(eye).mul(0.5).dot(normal)
                Lobe.REFLECTED -> Vector3d(normal).mul(2 * normal.dot(light)).sub(light).dot(eye)
            }
        }
        return Angle(variant.lobe, n, WayUse(l, variant.lightUnit, variant.lightSign), WayUse(v, variant.eyeUnit, variant.eyeSign), cosines)
    }

    private class Variant(val lobe: Lobe, val lightUnit: Boolean, val eyeUnit: Boolean, val lightSign: Double, val eyeSign: Double)

    /** The number that [node] is a power by. */
    private fun exponentNode(node: Node, exponent: Double): Node? {
        val seen = HashSet<Long>()
        val open = ArrayDeque(listOf(node))
        while (open.isNotEmpty()) {
            val next = open.removeFirst()
            if (!seen.add(next.key)) continue
            if (next.operation == Operation.POW && abs(next.operands[1].value - exponent) < 1e-6 * exponent) return next.operands[1]
            open += next.operands
        }
        return null
    }

    companion object {
        /** The points that vectors lead to, each once. */
        fun places(vectors: List<KnownVector>, spaces: Spaces): List<ToPoint> =
            vectors.mapNotNull { toPoint(it, spaces) }.sortedBy { it.vector.isUnit }.distinctBy { way ->
                listOf(way.space) + listOf(way.place.x(), way.place.y(), way.place.z()).map { Math.round(it * 1e6) }
            }

        /** The vectors that are the same everywhere. */
        fun constants(vectors: List<KnownVector>): List<KnownVector> =
            vectors.filter { !it.dependsOnNormal && !it.dependsOnPosition && it.constant.length() > 1e-9 }

        private const val FEWEST = 6

        /** The first samples lie anywhere; that is enough to tell highlights apart. */
        private const val FIRST = 40
        private const val EXACT = 1e-8
        private const val NEAR = 1e-4
        private val SIGNS = listOf(1.0, -1.0)

        /** The right ones first. */
        private val VARIANTS = Lobe.entries.flatMap { lobe ->
            listOf(1.0 to 1.0, 1.0 to -1.0, -1.0 to 1.0).flatMap { (l, v) ->
                listOf(true to true, true to false, false to true, false to false).map { (lu, vu) -> Variant(lobe, lu, vu, l, v) }
            }
        }
    }
}
