package cga.exercise.components.texture

import cga.exercise.components.shader.ShaderProgram
import org.lwjgl.opengl.GL30.*
import java.nio.ByteBuffer

/** The scene is drawn into this first, and this onto the screen. */
class Canvas(private val width: Int, private val height: Int) {
    private val picture = glGenTextures()
    private val depth = glGenRenderbuffers()
    private val framebuffer = glGenFramebuffers()
    private val nothing = glGenVertexArrays()

    init {
        glBindTexture(GL_TEXTURE_2D, picture)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, null as ByteBuffer?)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST)
        glBindTexture(GL_TEXTURE_2D, 0)

        glBindRenderbuffer(GL_RENDERBUFFER, depth)
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height)

        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture, 0)
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth)
        check(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) { "the framebuffer is not complete" }
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
    }

    fun fits(width: Int, height: Int) = width == this.width && height == this.height

    fun begin() {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        glViewport(0, 0, width, height)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
    }

    fun show(screen: ShaderProgram) {
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
        glViewport(0, 0, width, height)
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        glDisable(GL_DEPTH_TEST)
        screen.use()
        screen.setUniform("picture", 5)
        glActiveTexture(GL_TEXTURE5)
        glBindTexture(GL_TEXTURE_2D, picture)
        glBindVertexArray(nothing)
        glDrawArrays(GL_TRIANGLES, 0, 3)
        glBindVertexArray(0)
        glBindTexture(GL_TEXTURE_2D, 0)
        glEnable(GL_DEPTH_TEST)
    }

    fun cleanup() {
        glDeleteFramebuffers(framebuffer)
        glDeleteRenderbuffers(depth)
        glDeleteTextures(picture)
        glDeleteVertexArrays(nothing)
    }
}
