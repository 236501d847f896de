package cga.measure.accuracy.hard

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.ImageData
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3f
import org.lwjgl.opengl.GL33C.*
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min
import kotlin.math.sqrt

/** Two triangles as large as the world, a light 1 above them: the vectors at the corners are huge, the one that matters is not. */
internal object GroundCases {
    fun measure(): List<HardCase> = SIZES.map(::ground)

    private fun ground(size: Float): HardCase {
        val seen = draw(size)
        var naiveError = 0.0
        var ourError = 0.0
        for (row in 0 until SIDE) {
            for (column in 0 until SIDE) {
                // A camera 3 above the ground that looks straight down and 90° wide.
                val at = Vector3d(3 * ((column + 0.5) / SIDE * 2 - 1), 0.0, 3 * ((row + 0.5) / SIDE * 2 - 1))
                val truth = color(Vector3d(LIGHT).sub(at), Vector3d(LIGHT).sub(at))
                ourError = max(ourError, abs(truth - seen[4 * (row * SIDE + column)]))
                naiveError = max(naiveError, abs(truth - color(interpolatedDirection(at, size.toDouble()), Vector3d(LIGHT).sub(at))))
            }
        }
        return HardCase(
            "ground ±%s units, light 1 above it".format(size.toBigDecimal().stripTrailingZeros().toPlainString()),
            "l normalised at the vertices",
            255 * naiveError,
            "l interpolated, then normalised",
            255 * ourError,
            255 * bound(size),
            ErrorUnit.COLOR,
            "unit vectors bend between the corners",
        )
    }

    /**
     * A corner lies size·√2 away: its vector, three weights and their three products and sums round to 8u of that. What l is moved by moves
     * the colour by at most its steepest slope: cos α·F changes by less than 1.5 a unit where the light is 1 away. Besides the usual.
     */
    private fun bound(size: Float) = 1.5 * 8 * sqrt(2.0) * size * Rounding.U + Rounding.COSINE + Rounding.ATTENUATION + Rounding.PRODUCTS

    /** F·cos α, the normal being y. */
    private fun color(
        l: Vector3d,
        toLight: Vector3d,
    ): Double {
        val d = toLight.length()
        return max(l.y / l.length(), 0.0) / (K.x + K.y * d + K.z * d * d)
    }

    /** What interpolation makes of unit vectors at the corners of the triangle that [at] lies in. */
    private fun interpolatedDirection(
        at: Vector3d,
        size: Double,
    ): Vector3d {
        val u = (at.x + size) / (2 * size)
        val v = (at.z + size) / (2 * size)
        // The square is cut from (0, 0) to (1, 1).
        val corner = if (v > u) Vector3d(-size, 0.0, size) else Vector3d(size, 0.0, -size)
        return direction(Vector3d(-size, 0.0, -size))
            .mul(1 - max(u, v))
            .add(direction(corner).mul(abs(v - u)))
            .add(direction(Vector3d(size, 0.0, size)).mul(min(u, v)))
    }

    private fun direction(corner: Vector3d) = Vector3d(LIGHT).sub(corner).normalize()

    private fun draw(size: Float): FloatArray {
        val ground = Renderable(listOf(mesh(size)))
        val program = ShaderProgram("shaders/scene.vert", "shaders/scene.frag", mapOf("LIGHTS" to 1))
        val camera = TronCamera(aspect = 1f).apply {
            translateLocal(Vector3f(0f, 3f, 0f))
            rotateLocal((-Math.PI / 2).toFloat(), 0f, 0f)
        }
        val view = camera.calculateViewMatrix(Matrix4d())
        return RenderTarget(SIDE, SIDE, 0, ColorFormat.RGBA32F).use { target ->
            glDisable(GL_CULL_FACE)
            glDisable(GL_DEPTH_TEST)
            program.use()
            camera.bind(program)
            PointLight(LIGHT, Vector3f(1f), K).bind(program, "light[0]", view)
            program.setUniform("emissiveTint", Vector3f())
            program.setUniform("ambient", Vector3f())
            program.setUniform("blinnPhong", true)
            program.setUniform("inverseGamma", 1f)
            ground.render(program, view)
            ground.cleanup()
            program.cleanup()
            target.readFloats().rgba
        }
    }

    private fun mesh(size: Float): Mesh {
        val corners = listOf(-size to -size, -size to size, size to size, size to -size)
        val vertices = corners.flatMap { (x, z) -> listOf(x, 0f, z, 0f, 0f, 0f, 1f, 0f) }
        val attributes = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        return Mesh(vertices.toFloatArray(), intArrayOf(0, 1, 2, 0, 2, 3), attributes, Material(plain(1f), plain(0f), plain(0f)))
    }

    private fun plain(gray: Float) = Texture2D(ImageData.ofColor(gray, gray, gray), false)

    private const val SIDE = 64
    private val SIZES = listOf(22.4f, 1e3f, 1e4f, 1e5f)
    private val LIGHT = Vector3f(0.2537f, 1f, 0.5119f)
    private val K = Vector3f(1f, 0.5f, 0.1f)
}
