package cga.exercise.components.geometry

import cga.testing.Complex
import cga.testing.DOUBLE_ROUNDING
import cga.testing.FLOAT_ROUNDING
import cga.testing.QUARTER
import cga.testing.assertNear
import cga.testing.assertRefused
import cga.testing.rows
import cga.testing.turn
import org.joml.Matrix3d
import org.joml.Matrix4d
import org.joml.Matrix4f
import org.joml.Vector3d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import kotlin.random.Random

class TransformableTest {
    /** Quarter turns leave a cosine of 4.4e-8; of up to three of them, times the scales and shifts (≤ 10) of these tests. */
    private val byHand = 32 * FLOAT_ROUNDING

    /** Elements of a product of three turns: three sines and cosines, three products and a sum are rounded, none exceeds 1. */
    private val ofATurn = 8 * FLOAT_ROUNDING

    @Test
    fun `a new one is where its parent is`() {
        val new = Transformable()
        assertEquals(Matrix4f(), new.getLocalModelMatrix())
        assertEquals(Matrix4f(), new.getWorldModelMatrix())
        assertEquals(Vector3f(), new.getPosition())
        assertNull(new.parent)
        assertEquals(placed().getLocalModelMatrix(), Transformable(parent = placed()).getWorldModelMatrix())
    }

    @Test
    fun `rotateLocal turns about x, then y, then z`() {
        val turned = Transformable().apply { rotateLocal(QUARTER, QUARTER, QUARTER) }
        val expected =
            rows(
                0, 0, 1, 0,
                0, -1, 0, 0,
                1, 0, 0, 0,
                0, 0, 0, 1,
            )
        assertNear(expected, turned.getLocalModelMatrix(), byHand)
    }

    @Test
    fun `rotateLocal turns on the spot and in the object's own units`() {
        val turned = Transformable(rows(2, 0, 0, 5, 0, 3, 0, 6, 0, 0, 4, 7, 0, 0, 0, 1)).apply { rotateLocal(0f, QUARTER, 0f) }
        assertNear(rows(0, 0, 2, 5, 0, 3, 0, 6, -4, 0, 0, 7, 0, 0, 0, 1), turned.getLocalModelMatrix(), byHand)
    }

    @Test
    fun `rotateLocal is as exact as its floats for every angle`() {
        val random = Random(1)

        // Near a right angle JOML's float cosine, computed from the sine, is off by up to 2.4e-4: the angles to look at.
        fun nearQuarters() = random.nextInt(-4, 5) * QUARTER + random.nextFloat() * 0.001f
        repeat(10_000) {
            val (pitch, yaw, roll) = List(3) { if (random.nextBoolean()) nearQuarters() else random.nextFloat() * 12 - 6 }
            val turned = Transformable().apply { rotateLocal(pitch, yaw, roll) }
            assertNear(turn(pitch, yaw, roll), turned.getLocalModelMatrix().get3x3(Matrix3d()), ofATurn, "$pitch, $yaw, $roll")
        }
    }

    @Test
    fun `translateLocal moves along the object's axes in its units`() {
        val moved = Transformable().apply {
            rotateLocal(0f, QUARTER, 0f)
            scaleLocal(Vector3f(2f, 3f, 4f))
            translateLocal(Vector3f(1f, 1f, -1f))
        }
        assertNear(rows(0, 0, 4, -4, 0, 3, 0, 3, -2, 0, 0, -2, 0, 0, 0, 1), moved.getLocalModelMatrix(), byHand)
    }

    @Test
    fun `translateGlobal moves along the parent's axes in its units`() {
        val moved = placed()
        val before = moved.getLocalModelMatrix()
        moved.translateGlobal(Vector3f(1f, 2f, -3f))
        // Small whole numbers: sums of them are exact.
        assertEquals(before.getTranslation(Vector3f()).add(1f, 2f, -3f), moved.getPosition())
        assertEquals(before.get3x3(Matrix3d()), moved.getLocalModelMatrix().get3x3(Matrix3d()))
    }

    @Test
    fun `scaleLocal scales along the object's axes about its origin`() {
        val scaled = Transformable().apply {
            translateGlobal(Vector3f(1f, 2f, 3f))
            rotateLocal(0f, QUARTER, 0f)
            scaleLocal(Vector3f(2f, 3f, 4f))
        }
        assertNear(rows(0, 0, 4, 1, 0, 3, 0, 2, -2, 0, 0, 3, 0, 0, 0, 1), scaled.getLocalModelMatrix(), byHand)
    }

    @Test
    fun `rotateAroundPoint turns about the parent's axes through the point`() {
        val turned = Transformable().apply {
            translateGlobal(Vector3f(3f, 0f, 0f))
            rotateLocal(QUARTER, 0f, 0f)
            rotateAroundPoint(0f, QUARTER, 0f, Vector3f(1f, 0f, 0f))
        }
        assertNear(rows(0, 1, 0, 1, 0, 0, -1, 0, -1, 0, 0, -2, 0, 0, 0, 1), turned.getLocalModelMatrix(), byHand)
    }

    @Test
    fun `rotateAroundPoint turns in the order of rotateLocal`() {
        val turned = Transformable().apply { rotateAroundPoint(QUARTER, QUARTER, QUARTER, Vector3f(0f, 0f, 1f)) }
        assertNear(rows(0, 0, 1, -1, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1), turned.getLocalModelMatrix(), byHand)
    }

    @Test
    fun `rotateAroundPoint keeps the point and the distance to it`() {
        val random = Random(2)
        repeat(1_000) {
            val midpoint = random.vector(100f)
            val offset = random.vector(10f)
            val (pitch, yaw, roll) = List(3) { random.nextFloat() * 12 - 6 }
            val atMidpoint = Transformable().apply { translateGlobal(midpoint) }
            val beside = Transformable().apply { translateGlobal(Vector3f(midpoint).add(offset)) }
            val distance = Vector3d(beside.getPosition()).distance(Vector3d(midpoint))

            atMidpoint.rotateAroundPoint(pitch, yaw, roll, midpoint)
            beside.rotateAroundPoint(pitch, yaw, roll, midpoint)

            // Both T(m)·R·T(−m) and its product with a position sum four terms of at most |m| + |offset|, off by R's 8 roundings each.
            val tolerance = 2 * 4 * ofATurn * (midpoint.length() + offset.length())
            assertNear(midpoint, atMidpoint.getPosition(), tolerance)
            assertNear(distance, Vector3d(beside.getPosition()).distance(Vector3d(midpoint)), tolerance)
        }
    }

    @Test
    fun `setLocalModelMatrix replaces what was there`() {
        val replaced = placed().apply { setLocalModelMatrix(Matrix4f().translation(1f, 2f, 3f)) }
        assertEquals(Matrix4f().translation(1f, 2f, 3f), replaced.getLocalModelMatrix())
    }

    @Test
    fun `world getters go through the parents, the others do not`() {
        val grandparent = Transformable().apply { translateGlobal(Vector3f(10f, 0f, 0f)) }
        val parent = Transformable(parent = grandparent).apply {
            rotateLocal(0f, QUARTER, 0f)
            scaleLocal(Vector3f(2f))
        }
        val child = Transformable(parent = parent).apply {
            translateGlobal(Vector3f(0f, 1f, -3f))
            rotateLocal(QUARTER, 0f, 0f)
        }

        assertNear(rows(0, 2, 0, 4, 0, 0, -2, 2, -2, 0, 0, 0, 0, 0, 0, 1), child.getWorldModelMatrix(), byHand)
        assertNear(Vector3f(4f, 2f, 0f), child.getWorldPosition(), byHand)
        assertNear(Vector3f(0f, 0f, -1f), child.getWorldXAxis(), byHand)
        assertNear(Vector3f(1f, 0f, 0f), child.getWorldYAxis(), byHand)
        assertNear(Vector3f(0f, -1f, 0f), child.getWorldZAxis(), byHand)

        assertNear(rows(1, 0, 0, 0, 0, 0, -1, 1, 0, 1, 0, -3, 0, 0, 0, 1), child.getLocalModelMatrix(), byHand)
        assertEquals(Vector3f(0f, 1f, -3f), child.getPosition())
        assertNear(Vector3f(1f, 0f, 0f), child.getXAxis(), byHand)
        assertNear(Vector3f(0f, 0f, 1f), child.getYAxis(), byHand)
        assertNear(Vector3f(0f, -1f, 0f), child.getZAxis(), byHand)
    }

    @Test
    fun `a child follows its parent, and stays when it has none`() {
        val parent = Transformable()
        val child = Transformable(Matrix4f().translation(0f, 0f, 1f)).also { it.parent = parent }
        parent.translateGlobal(Vector3f(5f, 0f, 0f))
        assertEquals(Vector3f(5f, 0f, 1f), child.getWorldPosition())
        child.parent = null
        assertEquals(Vector3f(0f, 0f, 1f), child.getWorldPosition())
    }

    @Test
    fun `axes have unit length whatever the scale`() {
        val random = Random(3)
        repeat(1_000) {
            val scaled = Transformable().apply {
                rotateLocal(random.nextFloat(), random.nextFloat(), random.nextFloat())
                scaleLocal(Vector3f(random.scale(), random.scale(), random.scale()))
            }
            val child = Transformable(parent = scaled)
            val axes =
                with(child) { listOf(getWorldXAxis(), getWorldYAxis(), getWorldZAxis()) } +
                    with(scaled) { listOf(getXAxis(), getYAxis(), getZAxis()) }
            // Squares, their two sums, the root's reciprocal and the product with it: five roundings.
            for (axis in axes) assertNear(1.0, Vector3d(axis).length(), 5 * FLOAT_ROUNDING)
        }
    }

    @Test
    fun `a chain of 1,000 parents ends where the geometric series says`() {
        val link = Transformable().apply {
            rotateLocal(0f, 0.01f, 0f)
            translateLocal(Vector3f(0f, 0f, -1f))
        }
        val last = chain(1_001, link.getLocalModelMatrix())
        val matrix = link.getLocalModelMatrix()
        val expected = power(matrix, 1_001)

        // 1,001 products in double precision, four roundings a number; the numbers are at most 2 / |1 − q| = 200 large.
        val exact = last.getWorldModelMatrix(Matrix4d())
        assertNear(expected, exact, 4 * 1_001 * 200 * DOUBLE_ROUNDING)
        // The getter rounds that once.
        assertNear(expected, last.getWorldModelMatrix(), 200 * FLOAT_ROUNDING)
    }

    @Test
    fun `a chain of 100,000 parents does not overflow the stack`() {
        val last = chain(100_001, Matrix4f().translation(0f, 1f, 0f))
        assertEquals(Vector3f(0f, 100_001f, 0f), last.getWorldPosition())
        Transformable().parent = last
    }

    @Test
    fun `nothing can be its own ancestor`() {
        val first = Transformable()
        val second = Transformable(parent = first)
        val last = Transformable(parent = second)
        for (ancestor in listOf(first, second, last)) {
            val before = ancestor.parent
            val error = assertThrows<IllegalArgumentException> { ancestor.parent = last }
            assertTrue("cycle" in error.message.orEmpty()) { error.message }
            assertEquals(before, ancestor.parent, "the parent after the refusal")
        }
    }

    @Test
    fun `what is not finite is refused with its values, and changes nothing`() {
        for (bad in listOf(Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY)) {
            val vector = Vector3f(1f, bad, 2f)
            val target = placed()
            val before = target.getLocalModelMatrix()
            assertRefused(vector) { target.translateLocal(vector) }
            assertRefused(vector) { target.translateGlobal(vector) }
            assertRefused(vector) { target.scaleLocal(vector) }
            assertRefused(bad) { target.rotateLocal(0f, bad, 0f) }
            assertRefused(bad) { target.rotateAroundPoint(0f, 0f, bad, Vector3f()) }
            assertRefused(vector) { target.rotateAroundPoint(0f, 0f, 0f, vector) }
            assertRefused { target.setLocalModelMatrix(Matrix4f().translation(vector)) }
            assertRefused { Transformable(Matrix4f().translation(vector)) }
            assertEquals(before, target.getLocalModelMatrix())
        }
    }

    @Test
    fun `getters and setters copy`() {
        val given = Matrix4f()
        val set = Matrix4f()
        val target = Transformable(given)
        given.translation(1f, 1f, 1f)
        assertEquals(Matrix4f(), target.getLocalModelMatrix())
        target.setLocalModelMatrix(set)
        set.translation(1f, 1f, 1f)

        with(target) {
            for (matrix in listOf(getLocalModelMatrix(), getWorldModelMatrix())) matrix.scaling(7f)
            val vectors = listOf(getPosition(), getXAxis(), getYAxis(), getZAxis())
            val worldVectors = listOf(getWorldPosition(), getWorldXAxis(), getWorldYAxis(), getWorldZAxis())
            for (vector in vectors + worldVectors) vector.set(7f)
        }
        assertEquals(Matrix4f(), target.getLocalModelMatrix())
        assertEquals(Matrix4f(), target.getWorldModelMatrix())
    }

    /** Somewhere, turned by quarters and scaled: all numbers whole. */
    private fun placed() = Transformable(rows(0, 0, 4, 5, 0, 3, 0, 6, -2, 0, 0, 7, 0, 0, 0, 1))

    private fun chain(length: Int, matrix: Matrix4f): Transformable =
        generateSequence(Transformable(matrix)) { Transformable(matrix, it) }.elementAt(length - 1)

    /**
     * The [n]-th power of a turn about y followed by a shift in its plane, by complex numbers: with q the turn and s the shift
     * it turns by qⁿ and shifts by s·(1 + q + … + qⁿ⁻¹) = s·(1 − qⁿ)/(1 − q).
     */
    private fun power(matrix: Matrix4f, n: Int): Matrix4d {
        val q = Complex(matrix.m00().toDouble(), matrix.m02().toDouble())
        val s = Complex(matrix.m30().toDouble(), matrix.m32().toDouble())
        val one = Complex(1.0, 0.0)
        val turn = q.power(n)
        val shift = s * (one - turn) / (one - q)
        return Matrix4d(
            turn.re, 0.0, turn.im, 0.0,
            0.0, 1.0, 0.0, 0.0,
            -turn.im, 0.0, turn.re, 0.0,
            shift.re, 0.0, shift.im, 1.0,
        )
    }

    private fun Random.vector(size: Float) = Vector3f { nextFloat() * 2 * size - size }

    private fun Vector3f(next: () -> Float) = Vector3f(next(), next(), next())

    private fun Random.scale() = Math.pow(10.0, nextDouble(-13.0, 13.0)).toFloat()
}
