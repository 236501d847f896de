package cga.measure.accuracy

import cga.testing.FLOAT_ROUNDING
import cga.testing.Slow
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sin

/** Bounds are in ulps of a float of the column's largest number; u is a float's rounding, 2⁻²⁴ of a number, at most one such ulp. */
@Slow
class MatrixAccuracyTest {
    /**
     * JOML's double cosine is √(1 − sin²): near right angles the rounding of the sine and its square, 5/2·2⁻⁵³, becomes its root, 1.7e-8
     * or 0.28 ulp of a number from 1/2 to 1 (a unit vector's largest is 1/√3 or more). An element of a rotation has two such terms.
     * Ours is the cosine itself.
     */
    private val jomlCosines = 2 * 0.28

    /** One rounding, and double arithmetic before it. */
    private val rounded = 0.501

    private val bounds =
        mapOf(
            Operation.ROTATION to rounded,
            Operation.ENDLESS_ROTATION to rounded,
            // The rotation rounded and then scaled: twice as many ulps where the product is nearly a power of 2. The product rounded.
            Operation.PLACING to 2 * rounded + 0.5,
            Operation.TURN_ABOUT_POINT to rounded,
            // Three axes rounded make a turn that is off by √3·u at most, and by as much again when they are made orthonormal. It turns
            // the eye's position, whose largest coordinate is 1/√3 of its length or more. All rounded.
            Operation.CAMERA to 2 * SQRT3 * SQRT3 + 0.5,
            // The same of the offset from the eye, however far both are away; the model's own turn and scale, 2·√3·u, for its axes.
            Operation.MODEL_VIEW to 2 * SQRT3 * SQRT3 + 2 * SQRT3 + rounded,
            // Float arithmetic of JOML's: a product, a sum and a quotient.
            Operation.PERSPECTIVE to 3.0,
            Operation.NORMAL_MATRIX to rounded,
            // Five roundings for K_q·d², one for the sums before it, half of one for the quotient; F is below 2, whose ulp is 2u of 1.
            Operation.ATTENUATION to 6.5,
        )

    @Test
    fun `ours are as exact as their roundings allow, whatever JOML's options`() {
        for ((operation, bound) in bounds) {
            for (options in listOf("", "joml.useMathFma", "joml.sinLookup", "joml.fastmath", TABLE)) {
                for (figure in figures(operation, "ours", options)) assertTrue(figure.maxUlp <= bound) { "more than $bound ulp: $figure" }
            }
        }
    }

    @Test
    fun `ours are never NaN, and not worse than JOML's floats in any kind of case`() {
        val ours = figures.filter { it.implementation == "ours" && it.options == "" }
        val plainJoml = figures.filter {
            it.implementation == "JOML float" && it.options == "" && it.operation != Operation.ENDLESS_ROTATION
        }
        assertEquals(Operation.entries - Operation.LOOK_AT - Operation.CONE_OF_COSINES, ours.map { it.operation }.distinct())
        for (figure in ours) {
            assertEquals(0, figure.notFinite, "$figure")
            val joml = plainJoml.find { it.operation == figure.operation && it.kind == figure.kind } ?: continue
            assertTrue(figure.maxUlp <= joml.maxUlp || joml.notFinite > 0) { "$figure\n$joml" }
        }
    }

    /**
     * By elements: each factor is rounded so many times, and so is the sum of products that they add up to, which is no larger than
     * the same of absolute values. None of these cases has a cosine so small that JOML's would count.
     */
    @Test
    fun `ours follow long products`() {
        val roundings =
            mapOf(
                // Of each of four links turn and scale; of the product.
                Operation.PARENTS to 4 * 2 + 1,
                // Of the turn; in translateLocal, in floats, a product and three sums.
                Operation.MOVING to 1 + 1 + 3,
            )
        for (case in Oracle.read().filter { it.operation in roundings && it.kind != NEAR_RIGHT_ANGLES }) {
            val result = Ours.compute(case.operation, case.input()) ?: error("no $case")
            val sizes = absoluteProduct(case).get(DoubleArray(16))
            for (i in sizes.indices) {
                val bound = roundings.getValue(case.operation) * FLOAT_ROUNDING * sizes[i]
                assertTrue(abs(result[i] - case.truth[i]) <= bound) { "${case.operation}, ${case.kind}: $i is off by more than $bound" }
            }
        }
    }

    /**
     * δ: the two unit vectors' numbers are rounded, u each, and the light's length by 3u. It changes the versine c²/2 by c·δ + δ²/2;
     * all other roundings are relative to the versines, eight of them at most, and the quotient's.
     */
    @Test
    fun `our cones err by the rounding of their vectors over the cone's width`() {
        val delta = 5 * FLOAT_ROUNDING
        for (case in Oracle.read().filter { it.operation == Operation.CONE_OF_VERSINES }) {
            val result = Ours.compute(case.operation, case.input()) ?: error("no $case")
            val (inner, outer) = case.input().run { vector().also { vector() }.let { number().toDouble() to number().toDouble() } }
            val width = versine(outer) - versine(inner)
            val chord = 2 * sin(outer / 2)
            val bound = (chord * delta + delta * delta / 2 + 8 * FLOAT_ROUNDING * versine(outer)) / width + FLOAT_ROUNDING
            assertTrue(abs(result.single() - case.truth.single()) <= bound) { "from $inner to $outer rad: off by more than $bound" }
        }
    }

    @Test
    fun `GLM and JOML in doubles agree with the truth`() {
        for (figure in figures.filter { it.implementation == "GLM double" && it.operation != Operation.CONE_OF_COSINES }) {
            // The worst is the camera's: a position of 1e6 rounded eight times in double, beside an axis of 1 in floats.
            assertTrue(figure.maxUlp <= 8 * 1e6 / (1L shl 53) / FLOAT_ROUNDING && figure.notFinite == 0) { "$figure" }
        }
        val joml = figures.filter { it.implementation == "JOML double" && it.options == "" }
        for (figure in joml.filter { it.operation != Operation.ENDLESS_ROTATION }) {
            assertTrue(figure.maxUlp <= 2 * jomlCosines && figure.notFinite == 0) { "$figure" }
        }
    }

    @Test
    fun `JOML's float cosines are off near right angles, and not with fastmath`() {
        // √(1 − sin²) is 0 where the sine rounds to 1, which it does where the cosine is up to 2⁻¹², 4096 ulp. Two of them in a sum.
        val figure = figures(Operation.ROTATION, "JOML float").single { it.kind == NEAR_RIGHT_ANGLES }
        assertTrue(figure.maxUlp in 1000.0..2 * 4096.0) { "$figure" }
        assertTrue(worst(Operation.ROTATION, "JOML float", "joml.fastmath", NEAR_RIGHT_ANGLES) < 10)
        assertTrue(worst(Operation.ROTATION, "GLM float", "", NEAR_RIGHT_ANGLES) < 10)
    }

    @Test
    fun `JOML's cosines lose their sign where the turns no longer fit an int, or the float`() {
        assertTrue(worst(Operation.ENDLESS_ROTATION, "JOML double") > OFF_BY_1)
        assertTrue(worst(Operation.ROTATION, "JOML float", kind = "1e6 turns") > OFF_BY_1 / 10)
        assertTrue(worst(Operation.ENDLESS_ROTATION, "GLM float") < 10)
    }

    @Test
    fun `sinLookup without fastmath changes nothing`() {
        val plain = figures.filter { it.options == "" && "GLM" !in it.implementation }
        assertEquals(plain, figures.filter { it.options == "joml.sinLookup" }.map { it.copy(options = "") })
    }

    @Test
    fun `fused products change a little, fastmath's table more`() {
        fun mean(
            operation: Operation,
            kind: String,
            options: String = "",
        ) = figures(operation, "JOML float", options).single { it.kind == kind }.meanUlp
        val plain = mean(Operation.PARENTS, "any")
        val fused = mean(Operation.PARENTS, "any", "joml.useMathFma")
        assertTrue(fused != plain && fused < 2 * plain)
        // A table of 2¹⁴ sines, interpolated from an angle that is a float.
        assertTrue(mean(Operation.ROTATION, "any angles", TABLE) > 2 * mean(Operation.ROTATION, "any angles"))
    }

    @Test
    fun `the course's model-view is lost with the distance, ours is not`() {
        val joml = figures(Operation.MODEL_VIEW, "JOML float").map { it.maxUlp }
        assertEquals(6, joml.size)
        assertTrue(joml.last() > 1e4 * joml.first()) { "$joml" }
        assertTrue(worst(Operation.CAMERA, "GLM float", kind = "1e6 away") > 1e4)
    }

    @Test
    fun `float inverses lose normals that cofactors in double keep`() {
        val joml = figures(Operation.NORMAL_MATRIX, "JOML float").associateBy { it.kind }
        assertEquals(4, joml.getValue("1e-13 small").notFinite)
        assertTrue(figures(Operation.NORMAL_MATRIX, "GLM float").any { it.notFinite > 0 })
        // Turned inside out.
        for (who in listOf("JOML float", "GLM float")) {
            assertEquals(2.0, figures(Operation.NORMAL_MATRIX, who).single { it.kind == "nearly a line" }.maxRelative, 0.1)
        }
    }

    @Test
    fun `cosines lose narrow cones that versines keep`() {
        val step = (1 / 255.0) / Math.ulp(1f)
        val cosines = figures(Operation.CONE_OF_COSINES, "GLM float").associateBy { it.kind }
        assertTrue(cosines.getValue("0.01 degrees").run { notFinite > 0 && maxUlp > step })
        assertTrue(cosines.getValue("0.1 degrees").maxUlp > step)
        assertTrue(worst(Operation.CONE_OF_VERSINES, "ours", kind = "0.01 degrees") < step)
    }

    @Test
    fun `figures survive their own CSV`() {
        assertEquals(figures, figures.map { Figure.ofCsv(it.toCsv()) })
        for (line in figures.map { it.toCsv() }) assertEquals(Figure.HEADER.count { it == ',' }, line.count { it == ',' }, line)
    }

    private fun figures(
        operation: Operation,
        implementation: String,
        options: String = "",
    ): List<Figure> =
        figures
            .filter { it.operation == operation && it.implementation == implementation && it.options == options }
            .also { assertTrue(it.isNotEmpty()) { "no figures of $operation, $implementation, '$options'" } }

    private fun worst(
        operation: Operation,
        implementation: String,
        options: String = "",
        kind: String? = null,
    ): Double = figures(operation, implementation, options).filter { kind == null || it.kind == kind }.maxOf { it.maxUlp }

    private fun absoluteProduct(case: OracleCase): Matrix4d {
        val input = case.input()

        fun vector() = Vector3d(input.vector())

        fun placed() = absolute(Matrix4d().translate(vector()))
            .mul(vector().let { absolute(Matrix4d().rotateXYZ(it.x, it.y, it.z)) })
            .mul(absolute(if (case.operation == Operation.PARENTS) Matrix4d().scale(vector()) else Matrix4d().translate(vector())))
        val product = placed()
        while (input.hasMore()) product.mul(placed())
        return product
    }

    private fun absolute(m: Matrix4d) = Matrix4d().set(DoubleArray(16) { abs(m.get(it / 4, it % 4)) })

    private fun versine(angle: Double) = 2 * sin(angle / 2) * sin(angle / 2)

    private companion object {
        const val NEAR_RIGHT_ANGLES = "near right angles"
        const val TABLE = "joml.fastmath joml.sinLookup"
        const val SQRT3 = 1.7320508075688772

        /** In ulps of numbers from 1/2 to 1. */
        const val OFF_BY_1 = 1 / FLOAT_ROUNDING

        val figures: List<Figure> by lazy(MatrixAccuracy::measure)
    }
}
