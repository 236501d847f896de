package cga.exercise.components.skybox

import cga.exercise.components.camera.ICamera
import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix3f
import org.joml.Matrix4f
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL30.*
import java.nio.ByteBuffer
import kotlin.random.Random

/** Nachthimmel mit Sternen. Die Bilder dafuer werden hier berechnet, weil die aus dem Internet zu gross fuer das Git waren. */
class Skybox {
    private val vao = glGenVertexArrays()
    private val vbo = glGenBuffers()
    private val cubemap = glGenTextures()
    private val shader = ShaderProgram("assets/shaders/skybox_vert.glsl", "assets/shaders/skybox_frag.glsl")

    init {
        glBindVertexArray(vao)
        glBindBuffer(GL_ARRAY_BUFFER, vbo)
        glBufferData(GL_ARRAY_BUFFER, cube(), GL_STATIC_DRAW)
        glEnableVertexAttribArray(0)
        glVertexAttribPointer(0, 3, GL_FLOAT, false, 12, 0)
        glBindVertexArray(0)

        glBindTexture(GL_TEXTURE_CUBE_MAP, cubemap)
        for (face in 0 until 6) {
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, SIZE, SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE, face(face))
        }
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE)
        glBindTexture(GL_TEXTURE_CUBE_MAP, 0)
    }

    private fun face(face: Int): ByteBuffer {
        val random = Random(face)
        val pixels = BufferUtils.createByteBuffer(SIZE * SIZE * 3)
        for (y in 0 until SIZE) for (x in 0 until SIZE) {
            // oben dunkel, am Horizont etwas heller
            val horizon = when (face) {
                2 -> 0.0f
                3 -> 1.0f
                else -> y.toFloat() / SIZE
            }
            if (face != 3 && random.nextInt(400) == 0) {
                val star = 90 + random.nextInt(120)
                pixels.put(star.toByte()).put(star.toByte()).put(star.toByte())
            } else {
                pixels.put((6 + 10 * horizon).toInt().toByte())
                pixels.put((6 + 14 * horizon).toInt().toByte())
                pixels.put((16 + 34 * horizon).toInt().toByte())
            }
        }
        pixels.flip()
        return pixels
    }

    private fun cube(): FloatArray {
        val c = Array(8) { i ->
            floatArrayOf(if (i and 1 == 0) -1.0f else 1.0f, if (i and 2 == 0) -1.0f else 1.0f, if (i and 4 == 0) -1.0f else 1.0f)
        }
        val triangles = intArrayOf(
            0, 1, 3, 0, 3, 2, 5, 4, 6, 5, 6, 7, 4, 0, 2, 4, 2, 6,
            1, 5, 7, 1, 7, 3, 2, 3, 7, 2, 7, 6, 4, 5, 1, 4, 1, 0
        )
        return triangles.flatMap { c[it].toList() }.toFloatArray()
    }

    /** Nach der Szene aufrufen: der Himmel liegt ganz hinten (Tiefe 1). */
    fun render(camera: ICamera) {
        glDepthFunc(GL_LEQUAL)
        glDisable(GL_CULL_FACE)
        shader.use()
        // nur die Drehung der Kamera, sonst kann man aus dem Himmel herausfahren
        val view = Matrix4f(Matrix3f(camera.getCalculateViewMatrix()))
        shader.setUniform("view", view, false)
        shader.setUniform("projection", camera.getCalculateProjectionMatrix(), false)
        glActiveTexture(GL_TEXTURE0)
        glBindTexture(GL_TEXTURE_CUBE_MAP, cubemap)
        shader.setUniform("skybox", 0)
        glBindVertexArray(vao)
        glDrawArrays(GL_TRIANGLES, 0, 36)
        glBindVertexArray(0)
        glBindTexture(GL_TEXTURE_CUBE_MAP, 0)
        glEnable(GL_CULL_FACE)
        glDepthFunc(GL_LESS)
    }

    fun cleanup() {
        glDeleteTextures(cubemap)
        glDeleteBuffers(vbo)
        glDeleteVertexArrays(vao)
        shader.cleanup()
    }

    companion object {
        private const val SIZE = 128
    }
}
