package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Looks for points that a light shines on, and from those for the light itself.
 *
 * @param surface points on what is drawn, in view space.
 * @param isWide whether to look also where wrong ways would bring positions ([Detours]).
 */
internal class LightSearch(
    private val box: BlackBox,
    private val surface: List<Vector3d>,
    isWide: Boolean = false,
) {
    private val random = kotlin.random.Random(4)

    /** Points where vector uniforms would be, if they were positions in view space or in world space. */
    val hints: List<Vector3d> =
        box.program.uniforms
            .filter { it.components in 3..4 && !it.isSampler }
            .flatMap { slot ->
                val value = box.values[slot.name] ?: return@flatMap emptyList()
                val raw = Vector3d(value[0].toDouble(), value[1].toDouble(), value[2].toDouble())
                val detours = if (isWide) Detours.of(box.spaces, raw) else emptyList()
                if (!raw.isFinite) emptyList() else listOfNotNull(raw, box.spaces.view?.transformPosition(raw, Vector3d())) + detours
            }.plus(origins())
            .distinct()

    /** Directions that vector uniforms would be, likewise, and their opposites. */
    val axes: List<Vector3d> =
        box.program.uniforms
            .filter { it.components in 3..4 && !it.isSampler }
            .flatMap { slot ->
                val value = box.values[slot.name] ?: return@flatMap emptyList()
                val raw = Vector3d(value[0].toDouble(), value[1].toDouble(), value[2].toDouble())
                if (!raw.isFinite || !(raw.length() > 0)) return@flatMap emptyList()
                listOfNotNull(raw.normalize(), box.spaces.view?.transformDirection(raw, Vector3d())?.normalize())
            }.distinct()

    /** Where the lights are that are sent by their matrices: matrices that are none of those that vertices go through. */
    private fun origins(): List<Vector3d> {
        val known = listOfNotNull(box.spaces.model, box.spaces.view, box.spaces.modelView).map { it.getTranslation(Vector3d()) }
        return box.program.matrices
            .mapNotNull { box.values[it] }
            .filter { it[3] == 0f && it[7] == 0f && it[11] == 0f && it[15] == 1f }
            .map { VectorRef.vector(it, TRANSLATION) }
            .filter { origin -> origin.isFinite && known.none { it.distance(origin) < 1e-5 } }
            .flatMap { listOfNotNull(it, box.spaces.view?.transformPosition(it, Vector3d())) }
    }

    /** Points to look at before anything is known: the surface, and near every hint. */
    fun samples(directions: Int): List<Sample> {
        val onSurface = surface.map { Sample(it, Directions.random(random)) }
        val nearHints =
            hints.flatMap { hint ->
                Directions
                    .sphere(
                        directions,
                    ).map { Sample(Vector3d(it).mul(RADIUS).add(hint), Directions.random(random).mul(0.7).sub(it).normalize()) }
            }
        val inBeams = hints.flatMap { hint ->
            axes.flatMap { d ->
                listOf(RADIUS, -RADIUS).map {
                    Sample(
                        Vector3d(hint).fma(it, d),
                        Vector3d(d).mul(
                            if (it >
                                0
                            ) {
                                -1.0
                            } else {
                                1.0
                            },
                        ),
                    )
                }
            }
        }
        return onSurface + nearHints + inBeams.take(MOST)
    }

    /** The brightest of many points, or none where the light shines on none of them. */
    fun litPoints(
        probe: LightProbe,
        texels: Map<String, Double>,
    ): List<Vector3d> {
        for (directions in intArrayOf(FEW_DIRECTIONS, MANY_DIRECTIONS)) {
            val points = samples(directions).map { it.position }
            // Three normals that no direction is far from find light; six measure it.
            val found = points.zip(brightness(probe, points, texels)).filter { it.second > 0 }.sortedByDescending { it.second }.take(KEPT)
            if (found.size >= 4) return found.map { Vector3d(it.first) }
            // A narrow beam: along the ray through a point that is lit, and near it, all is lit.
            val beam = found.firstOrNull()?.first ?: continue
            val gradient = probe.gradients(listOf(beam), texels).first()
            val along = Vector3d(gradient.direction).normalize()
            val nearby =
                List(FEW * 8) {
                    Vector3d(beam).fma(random.nextDouble(-2.0, 1.0), along).add(Directions.random(random).mul(random.nextDouble(0.15)))
                }
            val lit = nearby.zip(brightness(probe, nearby, texels)).filter { it.second > 0 }.sortedByDescending { it.second }.take(KEPT)
            if (lit.size >= 4) return lit.map { it.first }
        }
        return emptyList()
    }

    /** Places the light; [points] are lit. A second look from all around it makes it exact. */
    fun place(
        probe: LightProbe,
        points: List<Vector3d>,
        texels: Map<String, Double>,
    ): Placement? {
        val rough = Placement.of(box.spaces, probe.gradients(points, texels)) ?: return null
        val around = RADII.flatMap { r -> Directions.sphere(64).map { rough.at(Vector3d(it).mul(r)) } }
        val gradients = probe.gradients(around + points, texels)
        val brightest = gradients.maxOf { it.strength }
        val lit = gradients.filter { it.strength > DIM * brightest }.sortedByDescending { it.strength }.take(MANY)
        val fine = Placement.of(box.spaces, lit)
        // Rays from one side alone agree well and say little: the look from all around counts, unless it contradicts itself.
        return if (fine == null || fine.error > maxOf(rough.error, Placement.ACCEPTED)) rough else fine
    }

    private fun brightness(
        probe: LightProbe,
        points: List<Vector3dc>,
        texels: Map<String, Double>,
    ): List<Double> {
        val shades = probe.shade(points.flatMap { p -> TETRAHEDRON.map { Sample(p, it) } }, texels)
        return points.indices.map { i -> (0..3).maxOf { shades[4 * i + it].let { s -> if (s.isFinite()) s else 0.0 } } }
    }

    companion object {
        /** Directions around each hint at a first look, and at one for narrow cones. */
        const val FEW_DIRECTIONS: Int = 24
        const val MANY_DIRECTIONS: Int = 160
        private const val TRANSLATION = 12
        private const val RADIUS = 1.5
        private const val MOST = 2000
        private const val FEW = 32
        private const val KEPT = 32
        private const val MANY = 160
        private const val DIM = 1e-4
        private val RADII = doubleArrayOf(0.6, 2.0, 6.0).toList()
        private val TETRAHEDRON: List<Vector3dc> =
            listOf(
                Vector3d(1.0, 1.0, 1.0),
                Vector3d(1.0, -1.0, -1.0),
                Vector3d(-1.0, 1.0, -1.0),
                Vector3d(-1.0, -1.0, 1.0),
            ).map { it.normalize() }
    }
}
