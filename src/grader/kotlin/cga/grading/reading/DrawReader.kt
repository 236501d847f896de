package cga.grading.reading

import cga.grading.capture.CapturedDraw
import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedLight
import cga.reader.shader.Source
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.acos

/** Reads the numbers of one draw by what its program was found to do with them. */
internal class DrawReader(private val reading: ProgramReading, private val lights: List<LightReading>) {
    private val cones = HashMap<List<Any?>, Factor.Cone?>()
    private val points = reading.samples.points.take(POINTS)

    /** What the lights are in [draw], which has [spaces]. */
    fun lights(draw: CapturedDraw, spaces: Spaces): List<ObservedLight> {
        reading.probe.set(ProgramReading.values(draw))
        val samples = Samples.of(reading.probe, points)
        if (samples.size == 0) return emptyList()
        return lights.mapNotNull { light(it, samples, spaces) }
    }

    private fun light(light: LightReading, samples: Samples, spaces: Spaces): ObservedLight? {
        val place = place(light.way, samples, spaces) ?: return null
        val toView = toView(light.way.space, spaces)
        val scale = scale(light, samples)
        val color = light.color?.let { nodes -> Vector3d(nodes.map { samples.values(it)[0] }.toDoubleArray()) } ?: Vector3d(1.0)
        return ObservedLight(
            light.name, toView.transformPosition(place), color.mul(scale), k(light, samples, spaces),
            light.cone?.let {
                cone(it, light.sign, samples, spaces, toView)
            },
            placedBy(light),
            isViewed = false,
            fadedBy(light),
        )
    }

    /** Constant factors of a light's diffuse term, or of the specular one where there is none. */
    private fun scale(light: LightReading, samples: Samples): Double {
        val term = (light.diffuse + light.specular).firstOrNull() ?: return 1.0
        return term.sign * term.factors.filterIsInstance<Factor.Scale>().fold(1.0) { product, it -> product * samples.values(it.node)[0] }
    }

    /** Where [way] leads to in this draw, in its space. */
    fun place(way: ToPoint, samples: Samples, spaces: Spaces): Vector3d? {
        val matrix = spaces.all()[way.space] ?: return null
        if (way.vector.isEnd) {
            return samples.traces[0]
                .vectors
                .find {
                    it.key == way.vector.key
                }?.nodes
                ?.let { Vector3d(it[0].value, it[1].value, it[2].value) }
        }
        val raw =
            reading.vectors.find { !it.isUnit && it.fromPosition == way.vector.fromPosition && it.constant == way.vector.constant }
                ?: return null
        val vector = samples.traces[0].vectors.find { it.key == raw.key } ?: return null
        val value = Vector3d(vector.nodes[0].value, vector.nodes[1].value, vector.nodes[2].value).mul(way.sign)
        return value.add(matrix.transformPosition(Vector3d(samples.points[0].position)))
    }

    private fun toView(space: Space, spaces: Spaces): Matrix4d =
        when (space) {
            Space.VIEW -> Matrix4d()
            Space.WORLD -> Matrix4d(spaces.view ?: spaces.modelView)
            Space.MODEL -> Matrix4d(spaces.modelView)
        }

    private fun k(light: LightReading, samples: Samples, spaces: Spaces): Vector3dc {
        val fade = light.fade ?: return Vector3d(1.0, 0.0, 0.0)
        val place = place(fade.way, samples, spaces) ?: return NONE
        val matrix = spaces.all()[fade.way.space] ?: return NONE
        val distances = samples.points.map { matrix.transformPosition(Vector3d(it.position)).distance(place) }
        val values = samples.values(fade.node)
        val numbers = DoubleArray(values.size) { if (fade.isNodeSum) values[it] else 1 / values[it] }
        if (numbers.any { !it.isFinite() }) return NONE
        val k = LeastSquares(distances.map { doubleArrayOf(1.0, it, it * it) }).solve(numbers, 1e-5) ?: return NONE
        return Vector3d(k[0], k[1], k[2])
    }

    private fun cone(cone: Factor.Cone, sign: Double, samples: Samples, spaces: Spaces, toView: Matrix4d): ObservedCone {
        val nodes = samples.traces[0].vectors.find { it.key == cone.axis.key }?.nodes
        val axis = nodes?.let { Vector3d(it[0].value, it[1].value, it[2].value) } ?: Vector3d()
        val now =
            coneNow(cone, samples, spaces, axis) ?: return ObservedCone(toView.transformDirection(axis.normalize()), Double.NaN, Double.NaN)
        // It shines to where it becomes brighter; all around but for a cone, it is that cone inside out.
        val ahead = if (now.slope < 0) -1.0 else 1.0
        val (full, dark) = edges(now).let { (full, dark) -> ahead * full to ahead * dark }
        val isInverted = full < 0 && dark < 0
        val direction = toView.transformDirection(Vector3d(axis)).normalize(if (isInverted) -ahead * sign else ahead * sign)

        fun angle(cosine: Double) = acos((if (isInverted) -cosine else cosine).coerceIn(-1.0, 1.0))
        return ObservedCone(direction, angle(full), angle(dark))
    }

    /** The cosines at which the light is full and at which it is dark. */
    private fun edges(cone: Factor.Cone): Pair<Double, Double> {
        if (cone.falloff == Falloff.HARD) return cone.offset to cone.offset
        val full = (1 - cone.offset) / cone.slope
        val dark = -cone.offset / cone.slope
        return if (cone.falloff == Falloff.IN_ANGLE) Math.cos(full) to Math.cos(dark) else full to dark
    }

    /** The cone with the numbers of this draw. Those of its shape seldom change, so a draw with the same has the same. */
    private fun coneNow(cone: Factor.Cone, samples: Samples, spaces: Spaces, axis: Vector3d): Factor.Cone? {
        if (cone.comparedAs != null) {
            val edge = cone.comparedAs.cosine(samples.values(cone.node)[0], axis.length())
            return Factor.Cone(cone.way, cone.axis, false, Falloff.HARD, cone.slope, edge, true, true, cone.node, cone.comparedAs)
        }
        val node = samples.traces[0].nodes.find { it.key == cone.node.key } ?: return null
        val scalars = sources(node).filter { it.slot.size == 1 }.map { it.slot.name to samples.traces[0].let { _ -> valueOf(node, it) } }
        return cones.getOrPut(listOf(cone.node.key, axis.length(), scalars)) {
            val place = place(cone.way, samples, spaces) ?: return@getOrPut null
            val way = ToPoint(cone.way.vector, cone.way.space, place, cone.way.sign)
            val now = with(cone.axis) { KnownVector(key, fromPosition, fromNormal, axis, isUnit, line, nodes) }
            Sweeps(reading.probe, spaces, samples.points[0]).shape(cone.node, way, now)
        }
    }

    private fun valueOf(node: Node, source: Source.Uniform): Double? = leaves(node).find { it.source == source }?.value

    private fun placedBy(light: LightReading): String? =
        light.way.vector.nodes
            .flatMap {
                sources(it)
            }.map { it.slot }
            .filter { it.columns == 1 && it.size in 3..4 }
            .map { it.name }
            .distinct()
            .singleOrNull()

    private fun fadedBy(light: LightReading): Set<String> {
        val fade = light.fade ?: return emptySet()
        val placed = setOfNotNull(placedBy(light))
        return sources(fade.node).map { it.slot }.filter { it.columns == 1 }.map { it.name }.toSet() - placed
    }

    private fun sources(node: Node): List<Source.Uniform> = leaves(node).mapNotNull { it.source as? Source.Uniform }

    private fun leaves(node: Node): List<Node> {
        val seen = HashSet<Long>()
        val found = ArrayList<Node>()
        val open = ArrayDeque(listOf(node))
        while (open.isNotEmpty()) {
            val next = open.removeLast()
            if (!seen.add(next.key)) continue
            if (next.operation == null) found += next
            open += next.operands
        }
        return found
    }

    private companion object {
        const val POINTS = 6
        val NONE = Vector3d(Double.NaN)
    }
}
