package cga.measure.accuracy.hard

import cga.exercise.components.light.PointLight
import cga.framework.SpecularModel
import org.joml.Vector3f
import org.joml.Vector3fc
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt
import kotlin.random.Random

/** Where an angle, a distance or a power of the lighting model has no value, or nearly none. */
internal class EdgeCases(private val probe: Probe) {
    fun measure(): List<HardCase> =
        listOf(atTheLight(), nearTheLight(), far(1e18f, "1e18"), far(2e19f, "2e19")) +
            listOf(opposite(), grazing(), behindTheEye(), zeroToTheZero(), leak(), noNormal()) +
            listOf(1e-26f, 1e26f).map(::shortNormal) + EXPONENTS.map(::exponent)

    /** d = 0: the naive form divides 0 by 0. */
    private fun atTheLight(): HardCase {
        val shot = Shot(lights = listOf(PointLight(Shot().position, WHITE, TABLE_1)))
        return case(
            "fragment at the light",
            "normalize(0)",
            Naive.diffuse(shot.normal, Vector3f()).toDouble(),
            "no contribution",
            error(shot),
            0.0,
            "0/0",
        )
    }

    /** F = 1/(K_q·d²) is beyond all floats, and times a cosine of 0 NaN. The truth beyond 1e18 is taken as 1e18, as the shader does. */
    private fun nearTheLight(): HardCase {
        val position = Vector3f()
        val light = PointLight(Vector3f(1.5e-19f, 0f, 0f), WHITE, Vector3f(0f, 0f, 0.1f))
        val shot = Shot(position, lights = listOf(light))
        val naive = Naive.attenuation(Vector3f(1.5e-19f, 0f, 0f), light.attenuation) * Naive.diffuse(shot.normal, Vector3f(1f, 0f, 0f))
        return case("K = (0, 0, 0.1), d = 1.5e-19, grazing", "F not limited", naive.toDouble(), "F ≤ 1e18", error(shot), 0.0, "∞·0")
    }

    /** In random directions. K_q = 0, so that beyond d² the formula would still have a value: the sheet's, and for 2e19 DESIGN's, F = 0. */
    private fun far(
        d: Float,
        label: String,
    ): HardCase {
        val random = Random(3)
        val shots =
            List(1_000) {
                Shot(normal = random.direction(1f), lights = listOf(PointLight(random.direction(d), WHITE, Vector3f(1f, 0f, 0f))))
            }
        val truths = shots.map { it.truth().color.x }
        val naive = shots.map { Naive.attenuation(it.toLight(), it.lights.single().attenuation) * Naive.diffuse(it.normal, it.toLight()) }
        val ours = probe.shade(shots)
        val bound = 255 * (Rounding.COSINE + Rounding.ATTENUATION + Rounding.PRODUCTS)
        val failure = if (d > 1.85e19f) "d² is ∞, 0·∞" else ""
        return case(
            "light at a distance of $label",
            "F and l of d²",
            255 * shots.indices.maxOf { abs(naive[it] - truths[it]) },
            "F = 0 where d² overflows",
            255 * shots.indices.maxOf { abs(ours[it].x - truths[it]) },
            bound,
            failure,
        )
    }

    /** Light and eye opposite each other, in directions that no float holds exactly: what is left of the half vector is rounding. */
    private fun opposite(): HardCase {
        val random = Random(1)
        val shots =
            List(1_000) {
                val position = random.direction(4f)
                val light = PointLight(position.mul(random.nextInt(2, 9).toFloat(), Vector3f()), WHITE, CONSTANT)
                Shot(position, random.direction(1f), diffuse = 0f, specular = 1f, k = 8f, lights = listOf(light))
            }
        val naive = shots.map { Naive.specular(it.specularModel, it.normal, it.toLight(), it.toCamera(), it.k).toDouble() }
        val worst = if (naive.any(Double::isNaN)) Double.NaN else 255 * naive.max()
        val ours = 255 * probe.shade(shots).maxOf { it.x.toDouble() }
        return case(
            "light and eye opposite, k = 8",
            "normalize(l + v)",
            worst,
            "no highlight below |l + v| = 1e-6",
            ours,
            0.0,
            "0/0, or the direction of a rounding error",
        )
    }

    /** Light and eye both in the plane of the surface, to within 1e-7 … 0.1. */
    private fun grazing(): HardCase {
        val random = Random(2)
        val shots =
            List(2_000) {
                val position = Vector3f(random.nextFloat() - 0.5f, 0f, -4f)
                val height = 10.0.pow(random.nextDouble(-7.0, -1.0)).toFloat() * if (random.nextBoolean()) 1 else -1
                val light = PointLight(Vector3f(position.x + 3f, height, -4f - random.nextFloat()), WHITE, CONSTANT)
                Shot(
                    position,
                    Vector3f(0f, 1f, 0f),
                    diffuse = 1f,
                    specular = 1f,
                    k = 60f,
                    specularModel = SpecularModel.PHONG,
                    lights = listOf(light),
                )
            }
        val seen = probe.shade(shots)
        val ours = shots.indices.maxOf { abs(seen[it].x - shots[it].truth().color.x) }
        val naive = shots.maxOf { maxOf(0.0, -Naive.dot(it.normal, Naive.normalize(it.toLight())).toDouble()) }
        val bound = Rounding.COSINE + Rounding.highlight(Rounding.PHONG_COSINE, 60.0) + 2 * Rounding.PRODUCTS
        return case(
            "grazing light and eye",
            "cos α not clamped",
            255 * naive,
            "max(cos α, 0)",
            255 * ours,
            255 * bound,
            "negative light below the horizon",
        )
    }

    /** A negative cosine to a power that is no whole number. */
    private fun behindTheEye(): HardCase {
        val shot = Shot(
            normal = Vector3f(0f, 1f, -1f),
            diffuse = 0f,
            specular = 1f,
            k = 8.5f,
            specularModel = SpecularModel.PHONG,
            lights = listOf(ABOVE),
        )
        val l = Naive.normalize(shot.toLight())
        val cosine = Naive.cosBeta(shot.specularModel, Naive.normalize(shot.normal), l, Naive.normalize(shot.toCamera()))
        return case(
            "mirrored away from the eye, k = 8.5",
            "pow(cos β, k)",
            cosine.pow(shot.k).toDouble(),
            "max(cos β, 0)^k",
            error(shot),
            0.0,
            "power of a negative number",
        )
    }

    private fun zeroToTheZero(): HardCase {
        val shot = Shot(
            normal = Vector3f(0f, 1f, 0f),
            diffuse = 0f,
            specular = 1f,
            k = 0f,
            specularModel = SpecularModel.PHONG,
            lights = listOf(ABOVE),
        )
        val naive = Naive.specular(shot.specularModel, shot.normal, shot.toLight(), shot.toCamera(), 0f) * 255.0
        return case(
            "pow(0, 0)",
            "pow(max(cos β, 0), k)",
            naive,
            "0 where cos β ≤ 0",
            error(shot),
            0.0,
            "undefined in GLSL; 1 on the JVM and on softpipe, 0 on llvmpipe",
        )
    }

    /** The sheet does not cut the highlight off behind the surface: cutting it off is another picture. */
    private fun leak(): HardCase {
        val light = PointLight(Vector3f(0f, 0.1f, -10f), WHITE, CONSTANT)
        val shot = Shot(diffuse = 0f, specular = 1f, k = 60f, lights = listOf(light))
        val lit = (0..400).map { shot.copy(normal = Vector3f(0f, 1f, it / 400f)) }.filter { it.truth().lights.single().cosAlpha < 0 }
        val seen = probe.shade(lit)
        val truths = lit.map { it.truth() }
        val ours = lit.indices.maxOf { abs(seen[it].x - truths[it].color.x) }
        val shortest = truths.minOf { Rounding.sumLength(it.lights.single(), it.toCamera) }
        val bound = Rounding.highlight(Rounding.halfCosine(shortest), 60.0) + Rounding.PRODUCTS
        return case(
            "highlight from behind the surface, k = 60",
            "0 where n·l < 0",
            255 * truths.maxOf { it.color.x },
            "not cut off, as on the sheet",
            255 * ours,
            255 * bound,
            "not the sheet's formula",
        )
    }

    /** Normals of two vertices that cancel half way between them. */
    private fun noNormal(): HardCase {
        val shot = Shot(normal = Vector3f(), specular = 1f, lights = listOf(ABOVE))
        return case(
            "interpolated normals that cancel",
            "normalize(0)",
            Naive.diffuse(shot.normal, shot.toLight()).toDouble(),
            "emission and ambient only",
            error(shot),
            0.0,
            "0/0",
        )
    }

    /** What the normal matrix of a model scaled by (1e-13, 1, 1e13) leaves of a normal along z, and the same the other way round. */
    private fun shortNormal(length: Float): HardCase {
        val shot = Shot(normal = Vector3f(0f, 0.6f * length, 0.8f * length), lights = listOf(ABOVE))
        val naive = abs(Naive.diffuse(shot.normal, shot.toLight()) - shot.truth().color.x)
        val bound = 255 * (Rounding.COSINE + 2 * Rounding.U + Rounding.PRODUCTS)
        return case(
            "normal of length ${if (length < 1) "1e-26" else "1e26"}",
            "n / √(n·n)",
            255 * naive,
            "scaled by a power of 2 first",
            error(shot),
            bound,
            "n·n is 0 or ∞",
        )
    }

    /** Highlights near their peak, where the power is steepest. */
    private fun exponent(k: Float): HardCase {
        val random = Random(3)
        val reach = 2 / sqrt(maxOf(k, 4f))
        val position = Vector3f(0.3f, 0.1f, -4f)
        val light = PointLight(Vector3f(-1f, 0.7f, 1f), WHITE, CONSTANT)
        val peak = Naive.normalize(light.getPosition().sub(position)).add(Naive.normalize(position.negate(Vector3f()))).normalize()
        val shots =
            List(2_000) {
                val normal = Vector3f(random.nextFloat() - 0.5f, random.nextFloat() - 0.5f, random.nextFloat() - 0.5f).mul(reach).add(peak)
                Shot(position, normal, diffuse = 0f, specular = 1f, k = k, lights = listOf(light))
            }
        val truths = shots.map { it.truth() }
        val seen = probe.shade(shots)
        val ours = shots.indices.maxOf { abs(seen[it].x - truths[it].color.x) }
        // The interpolated normal taken as it comes: half way between two that are 10° apart its length is cos 5°.
        val shrunk = shots.maxOf { shot ->
            val short = Naive.normalize(shot.normal).mul(COS_5)
            val half = Naive.cosBeta(shot.specularModel, short, Naive.normalize(shot.toLight()), Naive.normalize(shot.toCamera()))
            abs(maxOf(half, 0f).pow(k) - shot.truth().color.x)
        }
        val half = Rounding.halfCosine(Rounding.sumLength(truths[0].lights.single(), truths[0].toCamera))
        val bound = 255 * (Rounding.highlight(half, k.toDouble()) + Rounding.PRODUCTS)
        val failure = if (k > 1) "a length of 0.996 to the power of k" else ""
        return case(
            "highlight, k = ${k.toBigDecimal().stripTrailingZeros().toPlainString()}",
            "normal not renormalised",
            255 * shrunk,
            "normalised in each fragment",
            255 * ours,
            bound,
            failure,
        )
    }

    private fun error(shot: Shot) = 255.0 * abs(probe.shade(shot).x - shot.truth().color.x)

    private fun case(
        name: String,
        naive: String,
        naiveError: Double,
        ours: String,
        ourError: Double,
        bound: Double,
        failure: String,
    ) = HardCase(name, naive, naiveError, ours, ourError, bound, ErrorUnit.COLOR, failure)

    private fun Shot.toLight() = lights.single().getWorldPosition().sub(position)

    private fun Shot.toCamera() = position.negate(Vector3f())

    private fun Random.direction(length: Float): Vector3f =
        generateSequence { Vector3f(nextFloat() - 0.5f, nextFloat() - 0.5f, nextFloat() - 0.5f) }
            .first { it.length() > 0.1f }
            .normalize(length)

    private companion object {
        val WHITE: Vector3fc = Vector3f(1f)
        val CONSTANT: Vector3fc = Vector3f(1f, 0f, 0f)
        val TABLE_1: Vector3fc = Vector3f(1f, 0.5f, 0.1f)

        /** Straight above the point that is usually shaded: mirrored by a floor there it goes up again, at right angles to the eye. */
        val ABOVE = PointLight(Vector3f(0f, 4f, -4f), WHITE, CONSTANT)
        val EXPONENTS = listOf(0f, 1f, 60f, 1e3f, 1e4f, 3e4f, 1e5f)
        const val COS_5 = 0.9961947f
    }
}
