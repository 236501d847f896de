package cga.grading.study

import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt
import kotlin.random.Random

/** Sets of directions to look into; unit vectors all. */
internal object Directions {
    /** [count] directions spread evenly over the sphere (a Fibonacci lattice). */
    fun sphere(count: Int): List<Vector3dc> =
        List(count) { i ->
            val z = 1 - (2.0 * i + 1) / count
            val r = sqrt(1 - z * z)
            val azimuth = i * PI * (3 - sqrt(5.0))
            Vector3d(r * cos(azimuth), r * sin(azimuth), z)
        }

    /** A direction at the angle [theta] from the unit vector [axis]. */
    fun around(
        axis: Vector3dc,
        theta: Double,
        azimuth: Double,
    ): Vector3d {
        val other = if (abs(axis.x()) < 0.6) Vector3d(1.0, 0.0, 0.0) else Vector3d(0.0, 1.0, 0.0)
        val u = axis.cross(other, other).normalize()
        val v = axis.cross(u, Vector3d())
        return Vector3d(axis).mul(cos(theta)).fma(sin(theta) * cos(azimuth), u).fma(sin(theta) * sin(azimuth), v)
    }

    /** Any direction, all equally likely. */
    fun random(random: Random): Vector3d {
        val z = random.nextDouble(-1.0, 1.0)
        val azimuth = random.nextDouble(2 * PI)
        val r = sqrt(1 - z * z)
        return Vector3d(r * cos(azimuth), r * sin(azimuth), z)
    }

    /** x, y, z and their opposites. */
    val AXES: List<Vector3dc> =
        listOf(Vector3d(1.0, 0.0, 0.0), Vector3d(0.0, 1.0, 0.0), Vector3d(0.0, 0.0, 1.0)).flatMap { listOf(it, Vector3d(it).negate()) }
}
