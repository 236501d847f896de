package cga.grading.sandbox

import cga.framework.context.ContextKind
import cga.framework.context.OffscreenContext
import cga.testing.Offscreen
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.lwjgl.opengl.GL33C.*
import java.nio.ByteBuffer
import java.nio.file.Path
import kotlin.io.path.exists

/** A JVM with LWJGL and Mesa inside the sandbox. */
class DrawingTest {
    @Test
    fun `a picture is drawn inside, in software`() {
        val sandbox = Hostile.confined()
        Offscreen.openOrSkip(ContextKind.OSMESA).close()
        Hostile().use { hostile ->
            val classPath = System.getProperty("java.class.path").split(':').map { Path.of(it).toAbsolutePath() }.filter { it.exists() }
            val command = JavaCommand(classPath, Painter::class.java.name).command()
            val outcome = sandbox.run(Job(command, hostile.scratch, readOnly = classPath, environment = JavaCommand.MESA))
            assertTrue(outcome.isSuccess) { "${outcome.end}\n${outcome.output}\n${outcome.errors}" }
            assertEquals("255 128 0 llvmpipe", outcome.output.trim())
            assertEquals("", SafeFiles.list(hostile.scratch, 10).joinToString())
        }
    }
}

/** What is drawn inside: one pixel of orange. */
object Painter {
    @JvmStatic
    fun main(arguments: Array<String>) {
        OffscreenContext.open(ContextKind.OSMESA).use {
            val texture = glGenTextures()
            glBindTexture(GL_TEXTURE_2D, texture)
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, null as ByteBuffer?)
            glBindFramebuffer(GL_FRAMEBUFFER, glGenFramebuffers())
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0)
            glClearColor(1f, 0.5f, 0f, 1f)
            glClear(GL_COLOR_BUFFER_BIT)
            val pixel = ByteBuffer.allocateDirect(4)
            glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel)
            println(
                (0..2).joinToString(
                    " ",
                ) { "${pixel[it].toInt() and 0xff}" } + " " + glGetString(GL_RENDERER).orEmpty().substringBefore(' '),
            )
        }
    }
}
