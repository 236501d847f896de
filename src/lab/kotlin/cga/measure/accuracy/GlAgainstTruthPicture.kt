package cga.measure.accuracy

import cga.framework.Frame
import cga.reference.FragmentShader
import cga.reference.Projected
import cga.reference.ReferencePicture
import cga.reference.ReferenceRenderer
import cga.reference.ShadedPoint
import cga.reference.Triangles
import org.joml.Vector2d
import org.joml.Vector3dc
import java.util.stream.IntStream
import kotlin.math.max
import kotlin.math.pow

/** Which mip levels the truth is told with. */
internal enum class TrueLevels {
    /** From exact derivatives. */
    IDEAL,

    /** llvmpipe's ([GlAgainstTruthLevels]). */
    DRIVER,
}

/**
 * The truth about a frame, and at every pixel how far off OpenGL may be.
 *
 * @param grid steps of the driver's sub-pixel grid in a pixel.
 */
internal class GlAgainstTruthPicture(
    val frame: Frame,
    val width: Int,
    private val height: Int,
    private val grid: Int,
) {
    private val picture = ReferenceRenderer(frame, width, height).render()
    private val triangles = Triangles(frame, width, height)
    private val bounds = GlAgainstTruthBound(frame)
    private val textures =
        frame.draws.map { draw -> draw.material.run { listOf(emissive, diffuse, specular) }.map(::GlAgainstTruthTexture) }

    /** As [ReferencePicture.surface]. */
    val surface: IntArray get() = picture.surface

    /** Whether OpenGL may take a smaller level than the first of any of the pixel's textures. */
    val isMinified: BooleanArray = BooleanArray(width * height)

    private val rgb = mapOf(TrueLevels.IDEAL to picture.rgb, TrueLevels.DRIVER to DoubleArray(picture.rgb.size))
    private val floatBounds = TrueLevels.entries.associateWith { DoubleArray(picture.rgb.size) }
    private val byteBounds = TrueLevels.entries.associateWith { DoubleArray(picture.rgb.size) }

    init {
        IntStream.range(0, height).parallel().forEach { Row(it).run() }
    }

    /** Three numbers a pixel. */
    fun rgb(levels: TrueLevels): DoubleArray = rgb.getValue(levels)

    /** The most that each of the three numbers may be off; [bytes] for llvmpipe's 8-bit texture filter. */
    fun bound(
        levels: TrueLevels,
        bytes: Boolean,
    ): DoubleArray = (if (bytes) byteBounds else floatBounds).getValue(levels)

    /** All terms of a pixel that shows something. */
    fun point(
        pixel: Int,
        levels: TrueLevels,
    ): ShadedPoint {
        val x = pixel % width
        val y = height - 1 - pixel / width
        if (levels == TrueLevels.DRIVER) return GlAgainstTruthLevels(frame, triangles).shade(surface[pixel], x, y)
        val shader = FragmentShader(frame, triangles)
        return shader.newPoint().also { shader.shade(surface[pixel], x + 0.5, y + 0.5, it) }
    }

    /**
     * Whether a driver may show triangle [number] in [pixel] where the truth shows another. It must come within a step of the sub-pixel grid
     * of the pixel's centre, and there the other one must end, or be no nearer but for the rounding of depth to 24 bits.
     */
    fun mayShow(
        pixel: Int,
        number: Int,
    ): Boolean {
        val itsDepths = around(pixel, number)
        val trueDepths = around(pixel, surface[pixel])
        if (number != ReferencePicture.NO_SURFACE && itsDepths.isEmpty()) return false
        return trueDepths.size < POINTS * POINTS || (itsDepths.isNotEmpty() && itsDepths.min() <= trueDepths.max() + DEPTH_STEP)
    }

    /** Depths of triangle [number] at those of [POINTS]×[POINTS] points around the centre of [pixel] that it covers. */
    private fun around(
        pixel: Int,
        number: Int,
    ): List<Double> {
        if (number == ReferencePicture.NO_SURFACE) return emptyList()
        val projected = Projected().apply { look(triangles, number) }
        val steps = List(POINTS) { (it - POINTS / 2) / (POINTS / 2.0) / grid }
        return steps.flatMap { dy ->
            steps.mapNotNull { dx ->
                projected.at(pixel % width + 0.5 + dx, height - 1 - pixel / width + 0.5 + dy)
                projected.depth.takeIf { projected.covers }
            }
        }
    }

    /** A row from the top; each has its own scratch, and the rows are shared out among the threads. */
    private inner class Row(private val row: Int) {
        private val y = height - 1 - row + 0.5
        private val shader = FragmentShader(frame, triangles)
        private val ideal = shader.newPoint()
        private val ofDriver = GlAgainstTruthLevels(frame, triangles)
        private var number = ReferencePicture.NO_SURFACE
        private var varyings: GlAgainstTruthVaryings? = null

        fun run() {
            for (column in 0 until width) {
                val pixel = row * width + column
                if (surface[pixel] != ReferencePicture.NO_SURFACE) look(pixel, column, column + 0.5, varyings(surface[pixel]))
            }
        }

        private fun varyings(wanted: Int): GlAgainstTruthVaryings {
            val cached = varyings
            if (cached != null && number == wanted) return cached
            number = wanted
            return GlAgainstTruthVaryings(frame, triangles, wanted, grid).also { varyings = it }
        }

        private fun look(
            pixel: Int,
            column: Int,
            x: Double,
            varyings: GlAgainstTruthVaryings,
        ) {
            shader.shade(number, x, y, ideal)
            val driver = ofDriver.shade(number, column, height - 1 - row)
            for (c in 0..2) rgb(TrueLevels.DRIVER)[3 * pixel + c] = driver.color[c]

            val draw = frame.draws[ideal.draw]
            val shares = bounds.shares(varyings, x, y, draw.material.shininess.toDouble())
            val detail = GlAgainstTruthDetail(x, y, listOf(ideal.texCoordDx, ideal.texCoordDy), varyings::texCoordOrNull)
            val roundings = Vector2d(2 * varyings.texCoordRounding(0, x, y), 2 * varyings.texCoordRounding(1, x, y))
            val allowed = textures[ideal.draw].map { detail.allowed(it.width, it.height, roundings) }
            // The levels of the driver are known but for the errors of the differences that they come from.
            val errors = detail.bend().mul(1.0 / grid).add(roundings)
            val known = textures[ideal.draw].mapIndexed { i, texture -> around(ofDriver.lambdas[i], texture, errors) }
            isMinified[pixel] = allowed.any { it.endInclusive > 0 }

            for (bytes in listOf(false, true)) {
                fun bound(
                    point: ShadedPoint,
                    lambdas: List<ClosedFloatingPointRange<Double>>,
                ): BoundedVector {
                    val shown = listOf(point.emissive, point.diffuse, point.specular)
                    val s = varyings.texCoord(0, x, y)
                    val t = varyings.texCoord(1, x, y)
                    val (e, d, m) = textures[point.draw].mapIndexed { i, texture -> texture.bound(shown[i], s, t, lambdas[i], bytes) }
                    return bounds.color(e, d, m, draw.tint, shares)
                }
                store(bound(ideal, allowed), ideal.color, bound(TrueLevels.IDEAL, bytes), pixel)
                store(bound(driver, known), driver.color, bound(TrueLevels.DRIVER, bytes), pixel)
            }
        }

        private fun around(
            lambda: Double,
            texture: GlAgainstTruthTexture,
            errors: Vector2d,
        ): ClosedFloatingPointRange<Double> =
            GlAgainstTruthDetail.around(lambda, max(errors.x * texture.width, errors.y * texture.height) * 2 / 2.0.pow(lambda))

        private fun store(
            bound: BoundedVector,
            truth: Vector3dc,
            dest: DoubleArray,
            pixel: Int,
        ) {
            for (c in 0..2) {
                // Both compute the same colour, on different ways: what they differ by is a mistake in one of them.
                check(!bound[c].error.isFinite() || kotlin.math.abs(bound[c].value - truth[c]) <= SAME * max(1.0, truth[c])) {
                    "pixel $pixel: the bound is about ${bound[c].value}, the reference says $truth"
                }
                dest[3 * pixel + c] = if (bound[c].error.isNaN()) Double.POSITIVE_INFINITY else bound[c].error
            }
        }
    }

    private companion object {
        const val POINTS = 9
        const val DEPTH_STEP = 1.0 / (1 shl 24)

        /** Doubles, the planes of small triangles: far below any bound. */
        const val SAME = 1e-7
    }
}
