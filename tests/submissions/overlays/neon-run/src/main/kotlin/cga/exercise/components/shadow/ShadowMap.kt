package cga.exercise.components.shadow

import cga.exercise.components.shader.ShaderProgram
import org.joml.Matrix4f
import org.joml.Vector3f
import org.lwjgl.opengl.GL30.*
import java.nio.ByteBuffer

/** Depth of the scene as the moon sees it. */
class ShadowMap(private val toMoon: Vector3f) {
    private val fbo = glGenFramebuffers()
    private val depth = glGenTextures()
    private val shader = ShaderProgram("assets/shaders/shadow_vert.glsl", "assets/shaders/shadow_frag.glsl")

    private val moonMatrix = Matrix4f()
        .ortho(-35.0f, 35.0f, -35.0f, 35.0f, 1.0f, 90.0f)
        .lookAt(Vector3f(toMoon).mul(45.0f), Vector3f(0.0f), Vector3f(0.0f, 1.0f, 0.0f))

    init {
        glBindTexture(GL_TEXTURE_2D, depth)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, SIZE, SIZE, 0, GL_DEPTH_COMPONENT, GL_FLOAT, null as ByteBuffer?)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER)
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, floatArrayOf(1.0f, 1.0f, 1.0f, 1.0f))
        glBindFramebuffer(GL_FRAMEBUFFER, fbo)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0)
        glDrawBuffer(GL_NONE)
        glReadBuffer(GL_NONE)
        check(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) { "shadow framebuffer" }
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
    }

    /** Calls [draw] with the shader that writes only depth. */
    fun record(width: Int, height: Int, draw: (ShaderProgram) -> Unit) {
        glBindFramebuffer(GL_FRAMEBUFFER, fbo)
        glViewport(0, 0, SIZE, SIZE)
        glClear(GL_DEPTH_BUFFER_BIT)
        shader.use()
        shader.setUniform("moonMatrix", moonMatrix, false)
        draw(shader)
        glBindFramebuffer(GL_FRAMEBUFFER, 0)
        glViewport(0, 0, width, height)
    }

    fun bind(target: ShaderProgram, view: Matrix4f) {
        glActiveTexture(GL_TEXTURE0 + 5)
        glBindTexture(GL_TEXTURE_2D, depth)
        target.setUniform("shadowMap", 5)
        target.setUniform("moonMatrix", moonMatrix, false)
        target.setUniform("moonDirection", view.transformDirection(Vector3f(toMoon)))
        target.setUniform("moonColor", Vector3f(0.10f, 0.12f, 0.18f))
    }

    fun cleanup() {
        glDeleteFramebuffers(fbo)
        glDeleteTextures(depth)
        shader.cleanup()
    }

    companion object {
        private const val SIZE = 1024
    }
}
