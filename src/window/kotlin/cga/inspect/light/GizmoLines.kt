package cga.inspect.light

import org.joml.Vector3d
import org.joml.Vector3dc
import org.joml.Vector3fc
import java.nio.FloatBuffer
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/**
 * The shapes that stand for lights, as lines in world space: six floats a vertex (position, colour), two vertices a line. What does not fit
 * into [vertices] is left out. Allocates nothing after it is made.
 */
internal class GizmoLines(val vertices: FloatBuffer) {
    private val from = Vector3d()
    private val to = Vector3d()
    private val side = Vector3d()
    private val up = Vector3d()
    private var red = 1f
    private var green = 1f
    private var blue = 1f

    /** Starts anew. */
    fun clear() {
        vertices.clear()
    }

    /** The colour of what follows: that of a light, as bright as a screen can show it; a black light is grey. */
    fun color(light: Vector3fc) {
        val largest = maxOf(light.x(), light.y(), light.z())
        if (largest <= 0f) return color(DARK, DARK, DARK)
        color(light.x() / largest, light.y() / largest, light.z() / largest)
    }

    /** A three-dimensional star at [position], and a plumb line from it to the ground, y = 0, with a cross there. */
    fun marker(position: Vector3dc) {
        for (i in RAYS_OF_STAR.indices) {
            to.set(RAYS_OF_STAR[i]).normalize(STAR)
            line(from.set(position).sub(to), to.add(position))
        }
        val foot = from.set(position.x(), 0.0, position.z())
        line(position, foot)
        line(to.set(foot).add(-FOOT, 0.0, 0.0), side.set(foot).add(FOOT, 0.0, 0.0))
        line(to.set(foot).add(0.0, 0.0, -FOOT), side.set(foot).add(0.0, 0.0, FOOT))
    }

    /**
     * The cone of all directions at [angle] (radians, 0 to π/2) from the unit vector [direction]: [LENGTH] long from [apex], its rim round,
     * and [RAYS] lines on it.
     */
    fun cone(
        apex: Vector3dc,
        direction: Vector3dc,
        angle: Double,
    ) {
        // Two unit vectors across: first against the axis that the direction is farthest from.
        side.set(if (abs(direction.y()) < 0.9) Y else X).cross(direction).normalize()
        direction.cross(side, up)
        for (i in 0 until SEGMENTS) {
            rim(apex, direction, angle, i, from)
            rim(apex, direction, angle, i + 1, to)
            line(from, to)
            if (i % (SEGMENTS / RAYS) == 0) line(apex, from)
        }
    }

    /** Point [i] of the rim: at [LENGTH] along a ray of the cone. No tangent: that of 90° is infinite. */
    private fun rim(
        apex: Vector3dc,
        direction: Vector3dc,
        angle: Double,
        i: Int,
        dest: Vector3d,
    ) {
        val turn = 2 * PI * i / SEGMENTS
        dest
            .set(apex)
            .fma(LENGTH * cos(angle), direction)
            .fma(LENGTH * sin(angle) * cos(turn), side)
            .fma(LENGTH * sin(angle) * sin(turn), up)
    }

    private fun color(
        r: Float,
        g: Float,
        b: Float,
    ) {
        red = r
        green = g
        blue = b
    }

    private fun line(
        a: Vector3dc,
        b: Vector3dc,
    ) {
        if (vertices.remaining() < 2 * FLOATS) return
        vertex(a)
        vertex(b)
    }

    private fun vertex(p: Vector3dc) {
        vertices.put(p.x().toFloat()).put(p.y().toFloat()).put(p.z().toFloat()).put(red).put(green).put(blue)
    }

    companion object {
        /** Floats a vertex. */
        const val FLOATS: Int = 6

        /** Length of a cone's lines in world units. */
        const val LENGTH: Double = 6.0

        /** Pieces of a rim, and lines on the cone. */
        const val SEGMENTS: Int = 48
        const val RAYS: Int = 8
        private const val STAR = 0.22
        private const val FOOT = 0.15
        private const val DARK = 0.35f
        private val X: Vector3dc = Vector3d(1.0, 0.0, 0.0)
        private val Y: Vector3dc = Vector3d(0.0, 1.0, 0.0)
        private val RAYS_OF_STAR: List<Vector3dc> =
            listOf(X, Y, Vector3d(0.0, 0.0, 1.0)) +
                listOf(Vector3d(1.0, 1.0, 1.0), Vector3d(1.0, 1.0, -1.0), Vector3d(1.0, -1.0, 1.0), Vector3d(-1.0, 1.0, 1.0))
    }
}
