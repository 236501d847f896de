package cga.measure.accuracy

import cga.framework.Frame
import cga.reference.FragmentShader
import cga.reference.Lighting
import cga.reference.ShadedPoint
import cga.reference.TextureSampler
import cga.reference.Triangles
import org.joml.Vector2d
import org.joml.Vector3d
import kotlin.math.pow

/**
 * The truth but for the mip levels, which are those that Mesa's llvmpipe 22.3.6 takes. Two things make them others than the ideal ones, and
 * OpenGL allows the first: derivatives are differences within quads of 2×2 pixels, from the lower left one (GLSL 3.30, section 8.7). The
 * second it neither allows nor forbids: log2 is linear between powers of 2, which is up to 0.086 too small, halved since it is taken of ρ².
 *
 * For one thread.
 */
internal class GlAgainstTruthLevels(
    private val frame: Frame,
    triangles: Triangles,
) {
    private val shader = FragmentShader(frame, triangles)
    private val lighting = Lighting(frame)
    private val samplers =
        frame.draws.map { draw -> draw.material.run { listOf(emissive, diffuse, specular) }.map(::TextureSampler) }
    private val quad = List(3) { shader.newPoint() }
    private val dx = Vector2d()
    private val dy = Vector2d()

    /** λ of the emissive, the diffuse and the specular texture, of the point last shaded. */
    val lambdas: DoubleArray = DoubleArray(3)

    /** What triangle [number] shows in the pixel ([x], [y]), from the lower left. */
    fun shade(
        number: Int,
        x: Int,
        y: Int,
    ): ShadedPoint {
        val left = x / 2 * 2 + 0.5
        val bottom = y / 2 * 2 + 0.5
        shader.shade(number, left, bottom, quad[0])
        shader.shade(number, left + 1, bottom, quad[1])
        shader.shade(number, left, bottom + 1, quad[2])
        quad[1].texCoord.sub(quad[0].texCoord, dx)
        quad[2].texCoord.sub(quad[0].texCoord, dy)

        val point = shader.newPoint()
        shader.shade(number, x + 0.5, y + 0.5, point)
        val colors = listOf(point.emissive, point.diffuse, point.specular)
        for ((i, sampler) in samplers[point.draw].withIndex()) {
            val exact = sampler.levelOfDetail(dx, dy)
            val factor = 2.0.pow(-logError(exact))
            lambdas[i] = exact - logError(exact)
            sampler.sample(point.texCoord, dx.mul(factor, Vector2d()), dy.mul(factor, Vector2d()), colors[i])
        }
        val draw = frame.draws[point.draw]
        lighting.shade(point, Vector3d(draw.tint), draw.material.shininess.toDouble())
        return point
    }

    /** How much too small [lambda] comes out of the linear logarithm of ρ². */
    private fun logError(lambda: Double): Double {
        if (!lambda.isFinite()) return 0.0
        val squared = 2.0.pow(2 * lambda)
        val exponent = Math.getExponent(squared)
        return lambda - (exponent + squared / 2.0.pow(exponent) - 1) / 2
    }
}
