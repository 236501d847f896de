package cga.measure.accuracy.hard

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.framework.image.ImageData
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.joml.Vector3f
import org.lwjgl.opengl.GL33C.*

/**
 * How far behind one another two surfaces must lie for the depth buffer to tell them apart. With 24 bits one step at the distance z is
 *
 *     z²·(far − near) / (far·near) · 2⁻²⁴,
 *
 * so it is the near plane that decides, hardly the far one.
 */
internal object DepthCases {
    fun measure(): List<HardCase> =
        listOf(10f, 30f).map { z -> case(z, naive = TronCamera(near = 1e-4f), ours = TronCamera()) } +
            case(30f, naive = TronCamera(near = 1e-3f, far = 1e3f), ours = TronCamera(far = 1e5f))

    private fun case(
        z: Float,
        naive: TronCamera,
        ours: TronCamera,
    ) = HardCase(
        "two surfaces %.0f units away".format(z),
        "near %s, far %s".format(plain(naive.near), plain(naive.far)),
        toldApart(naive, z),
        "near %s, far %s".format(plain(ours.near), plain(ours.far)),
        toldApart(ours, z),
        // One step for the buffer's rounding of each of the two depths, one for that of z/w in floats (near 1 a float has steps of 2⁻²⁴),
        // times the ladder's rung; and the float's own step at z.
        RUNG * 3 * step(ours, z) + Math.ulp(z),
        ErrorUnit.WORLD,
        "a depth step there is %.2g units".format(step(naive, z)),
    )

    private fun step(
        camera: TronCamera,
        z: Float,
    ): Double = z.toDouble() * z * (camera.far - camera.near) / (camera.far.toDouble() * camera.near) / (1 shl 24)

    /** The smallest distance, on a ladder, from which on the nearer surface is seen everywhere around [z]; NaN where it never is. */
    private fun toldApart(
        camera: TronCamera,
        z: Float,
    ): Double =
        DepthTarget(camera).use { target ->
            val ladder = generateSequence(step(camera, z) / 64) { it * RUNG }.take(120).toList()
            ladder.zip(ladder.map { target.nearerIsSeen(z, it.toFloat()) }).takeLastWhile { it.second }.firstOrNull()?.first ?: Double.NaN
        }

    /** A row of pixels, each with a point of its own depth in it and one behind. */
    private class DepthTarget(camera: TronCamera) : AutoCloseable {
        private val target = RenderTarget(POINTS, 1, 0, ColorFormat.RGBA32F)
        private val program = ShaderProgram("shaders/scene.vert", "shaders/scene.frag", mapOf("LIGHTS" to 0))
        private val material = Material(plain(0f), plain(1f), plain(0f))
        private val vertices = glGenVertexArrays()

        init {
            program.use()
            camera.bind(program)
            program.setUniform("modelView", Matrix4f(), false)
            program.setUniform("normalMatrix", Matrix3f(), false)
            program.setUniform("ambient", Vector3f())
            program.setUniform("inverseGamma", 1f)
            glBindVertexArray(vertices)
            material.bind(program)
        }

        /** Draws the nearer points last: where depths are equal, they are not seen. */
        fun nearerIsSeen(
            z: Float,
            gap: Float,
        ): Boolean {
            glEnable(GL_DEPTH_TEST)
            glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
            for ((behind, gray) in listOf(gap to 0f, 0f to 1f)) {
                program.setUniform("emissiveTint", Vector3f(gray))
                for (i in 0 until POINTS) {
                    glViewport(i, 0, 1, 1)
                    glVertexAttrib3f(0, 0f, 0f, -z * (1 + i / 1e3f) - behind)
                    glDrawArrays(GL_POINTS, 0, 1)
                }
            }
            val rgba = target.readFloats().rgba
            return (0 until POINTS).all { rgba[4 * it] > 0.5f }
        }

        override fun close() {
            material.cleanup()
            program.cleanup()
            glDeleteVertexArrays(vertices)
            target.close()
        }

        private fun plain(gray: Float) = Texture2D(ImageData.ofColor(gray, gray, gray), false)
    }

    private fun plain(value: Float) = value.toBigDecimal().stripTrailingZeros().toPlainString()

    private const val POINTS = 64
    private const val RUNG = 1.1
}
