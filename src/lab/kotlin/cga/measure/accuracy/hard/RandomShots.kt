package cga.measure.accuracy.hard

import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.framework.SpecularModel
import org.joml.Vector3f
import org.joml.Vector3fc
import kotlin.math.PI
import kotlin.math.pow
import kotlin.random.Random

/** Points and lights from the whole domain of the lighting model: ordinary ones, all orders of magnitude, and its limits. */
internal class RandomShots(private val random: Random) {
    fun next(): Shot {
        val position = vector(COORDINATES)
        val spots = random.nextInt(2)
        return Shot(
            position = position,
            normal = normal(position),
            diffuse = random.nextInt(2).toFloat(),
            specular = random.nextInt(2).toFloat(),
            k = pick(EXPONENTS) { 10.0.pow(random.nextDouble(-3.0, 5.0)).toFloat() },
            specularModel = SpecularModel.entries.random(random),
            lights =
                List(random.nextInt(2 - spots, 3)) { PointLight(place(position), color(), attenuation()) } +
                    List(spots) { spot(position) },
        )
    }

    private fun spot(surface: Vector3fc): SpotLight {
        val outer = pick(ANGLES) { random.nextFloat() * RIGHT }
        val inner = if (random.nextInt(4) == 0) outer else outer * random.nextFloat()
        return SpotLight(place(surface), color(), inner, outer, attenuation()).apply {
            rotateLocal(6 * random.nextFloat(), 6 * random.nextFloat(), 0f)
        }
    }

    /** Anywhere, at the surface, close to it, or opposite the eye. */
    private fun place(surface: Vector3fc): Vector3f =
        when (random.nextInt(8)) {
            0 -> Vector3f(surface)
            1 -> vector(COORDINATES).mul(10.0.pow(random.nextDouble(-25.0, 0.0)).toFloat()).add(surface)
            2 -> surface.mul(random.nextInt(2, 7).toFloat(), Vector3f())
            else -> vector(COORDINATES)
        }.let { if (it.isFinite) it else Vector3f(1f) }

    /** Any, none, tiny, huge, towards the eye, or at right angles to it. */
    private fun normal(position: Vector3fc): Vector3f =
        when (random.nextInt(8)) {
            0 -> Vector3f()
            1 -> vector(listOf(0f, 1f)).mul(10.0.pow(random.nextDouble(-38.0, 38.0)).toFloat())
            2 -> position.negate(Vector3f())
            3 -> Vector3f(position.y(), -position.x(), 0f)
            else -> vector(listOf(0f, 1f, -1f))
        }.let { if (it.isFinite) it else Vector3f(0f, 0f, 1f) }

    private fun color(): Vector3f = Vector3f { pick(COLORS) { 10 * random.nextFloat() } }

    private fun attenuation(): Vector3f =
        Vector3f { pick(FACTORS) { random.nextFloat() } }.let { if (maxOf(it.x, it.y, it.z) > 0f) it else Vector3f(0f, 0f, 1f) }

    private fun vector(limits: List<Float>): Vector3f = Vector3f { sign() * pick(limits) { 10 * random.nextFloat() } }

    private fun Vector3f(number: () -> Float) = Vector3f(number(), number(), number())

    private fun sign() = if (random.nextBoolean()) 1f else -1f

    /** A limit, one time in eight; else an ordinary number. */
    private fun pick(
        limits: List<Float>,
        ordinary: () -> Float,
    ): Float = if (random.nextInt(8) == 0) limits.random(random) else ordinary()

    private companion object {
        const val RIGHT = (PI / 2).toFloat()
        val SMALL = listOf(0f, 1e-38f, 1e-30f, 1e-20f, 1.1e-19f, 1e-10f, 1e-3f)
        val COORDINATES = SMALL + listOf(1f, 1e3f, 1e9f, 1e18f, 1.8446e19f, 2e19f, 1e30f, 3e38f)
        val EXPONENTS = listOf(0f, 1e-30f, 1f, 60f, 1e5f, 3e38f)
        val ANGLES = listOf(0f, 1e-38f, 1e-20f, 1e-7f, 1.7e-5f, 1.7e-3f, 1f, RIGHT)
        val COLORS = listOf(0f, -1f, 1f, 16f, 1e6f, 1e18f)
        val FACTORS = listOf(0f, 1e-38f, 1e-20f, 1e-18f, 0.1f, 1f, 1e10f, 3e38f)
    }
}
