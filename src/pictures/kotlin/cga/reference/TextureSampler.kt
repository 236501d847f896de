package cga.reference

import cga.framework.FrameTexture
import cga.framework.image.TextureImage
import org.joml.Vector2dc
import org.joml.Vector3d
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log2
import kotlin.math.max

/**
 * A two-dimensional texture as OpenGL 3.3 core samples it, sections 3.8.11 (minification) and 3.8.12 (magnification), in double
 * precision and with the ideal scale factor ρ of equation 3.21. OpenGL lets a driver take any continuous function between
 * max(m_u, m_v) and m_u + m_v in its place, m being the larger derivative of u and of v.
 */
public class TextureSampler(texture: FrameTexture) {
    private val color = texture.image.color
    private val levels = texture.image.levels
    private val wrapS = WrapMode.of(texture.wrapS)
    private val wrapT = WrapMode.of(texture.wrapT)
    private val minFilter = TextureFilter.of(texture.minFilter)
    private val magFilter = TextureFilter.of(texture.magFilter)
    private val width = levels[0].width
    private val height = levels[0].height

    /** q, the smallest level. */
    private val last = levels.lastIndex

    /** c, the λ from which on a texture is minified (section 3.8.12): where the sharper mip level's blur joins on to magnification's. */
    private val switchOver = if (magFilter == TextureFilter.LINEAR && isSharp(minFilter)) 0.5 else 0.0

    init {
        require(
            magFilter.levels == TextureFilter.Levels.FIRST,
        ) { "a texture cannot be magnified with $magFilter, which chooses mip levels" }
    }

    /**
     * The linear RGB at the texture coordinates [at], into [dest].
     *
     * @param dx how the coordinates change from one pixel to the next on the right; [dy] upwards.
     */
    public fun sample(
        at: Vector2dc,
        dx: Vector2dc,
        dy: Vector2dc,
        dest: Vector3d,
    ): Vector3d {
        if (color != null) return dest.set(color)
        dest.zero()
        val lambda = levelOfDetail(dx, dy)
        if (lambda <= switchOver) {
            filter(0, at, magFilter.isLinear, 1.0, dest)
            return dest
        }
        when (minFilter.levels) {
            TextureFilter.Levels.FIRST -> filter(0, at, minFilter.isLinear, 1.0, dest)
            TextureFilter.Levels.NEAREST -> filter(nearestLevel(lambda), at, minFilter.isLinear, 1.0, dest)
            TextureFilter.Levels.BETWEEN -> betweenLevels(lambda, at, dest)
        }
        return dest
    }

    /** λ = log2 ρ (equations 3.17 to 3.21): 0 where a pixel is as large as a texel, 1 where it spans two. */
    public fun levelOfDetail(
        dx: Vector2dc,
        dy: Vector2dc,
    ): Double = log2(max(squaredLength(dx), squaredLength(dy))) / 2

    /** (∂u)² + (∂v)², in texels. */
    private fun squaredLength(change: Vector2dc): Double {
        val u = width * change.x()
        val v = height * change.y()
        return u * u + v * v
    }

    /** Equation 3.24. */
    private fun nearestLevel(lambda: Double): Int =
        when {
            lambda <= 0.5 -> 0
            lambda > last + 0.5 -> last
            else -> ceil(lambda + 0.5).toInt() - 1
        }

    /** Equations 3.25 and 3.26, and τ = [1 − frac(λ)]·τ1 + frac(λ)·τ2. */
    private fun betweenLevels(
        lambda: Double,
        at: Vector2dc,
        dest: Vector3d,
    ) {
        if (lambda >= last) return filter(last, at, minFilter.isLinear, 1.0, dest)
        val larger = floor(lambda)
        val share = lambda - larger
        filter(larger.toInt(), at, minFilter.isLinear, 1 - share, dest)
        filter(larger.toInt() + 1, at, minFilter.isLinear, share, dest)
    }

    /** Adds [weight] times what one level shows at [at]: the nearest texel, or equation 3.23 in two dimensions. */
    private fun filter(
        level: Int,
        at: Vector2dc,
        isLinear: Boolean,
        weight: Double,
        dest: Vector3d,
    ) {
        val image = levels[level]
        val u = at.x() * image.width
        val v = at.y() * image.height
        if (!isLinear) {
            val i = wrapS.texel(floor(u).toLong(), image.width)
            val j = wrapT.texel(floor(v).toLong(), image.height)
            return add(image, i, j, weight, dest)
        }
        val left = floor(u - 0.5)
        val below = floor(v - 0.5)
        val alpha = u - 0.5 - left
        val beta = v - 0.5 - below
        val i0 = wrapS.texel(left.toLong(), image.width)
        val i1 = wrapS.texel(left.toLong() + 1, image.width)
        val j0 = wrapT.texel(below.toLong(), image.height)
        val j1 = wrapT.texel(below.toLong() + 1, image.height)
        add(image, i0, j0, (1 - alpha) * (1 - beta) * weight, dest)
        add(image, i1, j0, alpha * (1 - beta) * weight, dest)
        add(image, i0, j1, (1 - alpha) * beta * weight, dest)
        add(image, i1, j1, alpha * beta * weight, dest)
    }

    /** Adds [weight] times the texel ([i], [j]), column and row from the lower left corner; the border is black. */
    private fun add(
        image: TextureImage.Level,
        i: Int,
        j: Int,
        weight: Double,
        dest: Vector3d,
    ) {
        if (i == WrapMode.BORDER || j == WrapMode.BORDER) return
        val texel = 4 * (j * image.width + i)
        // A byte c stands for c/255 (equation 2.1).
        val share = weight / 255
        dest.x += share * (image.rgba[texel].toInt() and 0xFF)
        dest.y += share * (image.rgba[texel + 1].toInt() and 0xFF)
        dest.z += share * (image.rgba[texel + 2].toInt() and 0xFF)
    }

    private companion object {
        fun isSharp(filter: TextureFilter) =
            filter == TextureFilter.NEAREST_MIPMAP_NEAREST || filter == TextureFilter.NEAREST_MIPMAP_LINEAR
    }
}
