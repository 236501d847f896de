package cga.exercise.components.effects

import cga.exercise.components.camera.ICamera
import cga.exercise.components.geometry.Cube
import cga.exercise.components.shader.ShaderProgram
import org.lwjgl.BufferUtils
import org.lwjgl.opengl.GL30.*
import java.util.Random

/** Sternenhimmel als Cube Map. Die Bilder werden ausgerechnet, dann müssen keine ins Repository. */
class Skybox {
    private val shader = ShaderProgram("assets/shaders/skybox_vert.glsl", "assets/shaders/skybox_frag.glsl")
    private val cube = Cube.create(null)
    private val texture = glGenTextures()

    init {
        val random = Random(4711)
        glBindTexture(GL_TEXTURE_CUBE_MAP, texture)
        for (face in 0 until 6) {
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, stars(random))
        }
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE)
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE)
        glBindTexture(GL_TEXTURE_CUBE_MAP, 0)
    }

    private fun stars(random: Random) = BufferUtils.createByteBuffer(SIZE * SIZE * 4).apply {
        for (i in 0 until SIZE * SIZE) {
            val star = random.nextInt(400) == 0
            val light = if (star) 90 + random.nextInt(120) else 0
            put(maxOf(6, light).toByte()).put(maxOf(8, light).toByte()).put(maxOf(26, light).toByte()).put(255.toByte())
        }
        flip()
    }

    /** Als letztes von den 3D-Sachen zeichnen. */
    fun render(camera: ICamera) {
        glDepthFunc(GL_LEQUAL)
        glDisable(GL_CULL_FACE)
        shader.use()
        camera.bind(shader)
        glActiveTexture(GL_TEXTURE0)
        glBindTexture(GL_TEXTURE_CUBE_MAP, texture)
        shader.setUniform("skybox", 0)
        cube.render()
        glBindTexture(GL_TEXTURE_CUBE_MAP, 0)
        glEnable(GL_CULL_FACE)
        glDepthFunc(GL_LESS)
    }

    fun cleanup() {
        glDeleteTextures(texture)
        cube.cleanup()
        shader.cleanup()
    }

    companion object {
        private const val SIZE = 128
    }
}
