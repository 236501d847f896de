package cga.measure.accuracy

import cga.framework.FrameTexture
import cga.framework.image.TextureImage
import cga.reference.TextureFilter
import cga.reference.TextureSampler
import cga.reference.WrapMode
import org.joml.Vector2d
import org.joml.Vector3d
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.max
import kotlin.math.pow

/**
 * How far off what a texture shows may be, when texture coordinates and λ are known no better than they are.
 *
 * OpenGL says neither with how many bits the weights of a filter are computed nor how they are rounded. For a float filter a few roundings
 * are assumed; for llvmpipe's 8-bit filter, that places and λ are cut to 1/256 and that each of the three linear interpolations, across,
 * upwards, and between levels, ends on one of the two nearest bytes.
 */
internal class GlAgainstTruthTexture(texture: FrameTexture) {
    private val sampler = TextureSampler(texture)
    private val levels = texture.image.levels
    private val last = if (TextureFilter.of(texture.minFilter).levels == TextureFilter.Levels.FIRST) 0 else levels.lastIndex
    private val wrapS = WrapMode.of(texture.wrapS)
    private val wrapT = WrapMode.of(texture.wrapT)

    /** Of level 0, in texels. */
    val width: Int get() = levels[0].width
    val height: Int get() = levels[0].height

    /**
     * The color [shown] at ([s], [t]), with bounds.
     *
     * @param lambda all that may be taken for λ, including what [shown] was taken with.
     * @param bytes whether the filter counts in bytes.
     */
    fun bound(
        shown: Vector3d,
        s: Bounded,
        t: Bounded,
        lambda: ClosedFloatingPointRange<Double>,
        bytes: Boolean,
    ): BoundedVector {
        val margin = if (bytes) PLACE_STEP else 0.0
        val lowest = (lambda.start - margin).coerceIn(0.0, last.toDouble())
        val highest = (lambda.endInclusive + margin).coerceIn(0.0, last.toDouble())
        val at = Vector2d(s.value, t.value)
        val rounding = if (bytes) BYTE_ROUNDINGS / 255 else FLOAT_ROUNDINGS * Bounded.ULP
        val place = (
            floor(
                lowest,
            ).toInt()..ceil(highest).toInt()
        ).fold(Vector3d()) { worst, level -> worst.max(change(level, s, t, margin)) }
        // Between two levels the colour is linear in λ: the extremes are at whole numbers and at the ends.
        val extremes = (ceil(lowest).toInt()..floor(highest).toInt()).map { it.toDouble() } + lowest + highest
        val level = Vector3d()
        val scratch = Vector3d()
        for (l in extremes) level.max(sampler.sample(at, Vector2d(2.0.pow(l) / width, 0.0), NONE, scratch).sub(shown).absolute())
        level.add(place).add(rounding, rounding, rounding)
        return BoundedVector(Bounded(shown.x, level.x), Bounded(shown.y, level.y), Bounded(shown.z, level.z))
    }

    /** How much the colour of a level can change within the errors of the place: |∂τ/∂u|·Δu + |∂τ/∂v|·Δv, the steepest slopes nearby. */
    private fun change(
        level: Int,
        s: Bounded,
        t: Bounded,
        margin: Double,
    ): Vector3d {
        val image = levels[level]
        val du = s.error * image.width + margin
        val dv = t.error * image.height + margin
        val u = s.value * image.width - 0.5
        val v = t.value * image.height - 0.5
        // Too uncertain to look: anything from black to white.
        if (!(max(du, dv) < MOST_TEXELS)) return Vector3d(1.0)
        val columns = floor(u - du).toLong()..floor(u + du).toLong() + 1
        val rows = floor(v - dv).toLong()..floor(v + dv).toLong() + 1
        val across = Vector3d()
        val upwards = Vector3d()
        for (j in rows) {
            for (i in columns) {
                if (i < columns.last) across.max(difference(image, i, j, i + 1, j))
                if (j < rows.last) upwards.max(difference(image, i, j, i, j + 1))
            }
        }
        return across.mul(du).add(upwards.mul(dv))
    }

    private fun difference(
        image: TextureImage.Level,
        i0: Long,
        j0: Long,
        i1: Long,
        j1: Long,
    ): Vector3d {
        val a = index(image, i0, j0)
        val b = index(image, i1, j1)
        return Vector3d(
            abs(channel(image, a, 0) - channel(image, b, 0)),
            abs(channel(image, a, 1) - channel(image, b, 1)),
            abs(channel(image, a, 2) - channel(image, b, 2)),
        )
    }

    /** −1 on the border. */
    private fun index(
        image: TextureImage.Level,
        i: Long,
        j: Long,
    ): Int {
        val column = wrapS.texel(i, image.width)
        val row = wrapT.texel(j, image.height)
        return if (column == WrapMode.BORDER || row == WrapMode.BORDER) -1 else 4 * (row * image.width + column)
    }

    private fun channel(
        image: TextureImage.Level,
        index: Int,
        c: Int,
    ) = if (index < 0) 0.0 else (image.rgba[index + c].toInt() and 0xFF) / 255.0

    private companion object {
        val NONE = Vector2d()

        /** Of llvmpipe's 8-bit filter, in texels and levels. */
        const val PLACE_STEP = 1.0 / 256
        const val BYTE_ROUNDINGS = 3.0
        const val FLOAT_ROUNDINGS = 8.0
        const val MOST_TEXELS = 4.0
    }
}
