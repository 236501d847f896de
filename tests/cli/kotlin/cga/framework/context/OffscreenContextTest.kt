package cga.framework.context

import cga.framework.ColorFormat
import cga.framework.RenderTarget
import cga.testing.CgaProcess
import cga.testing.Offscreen
import cga.testing.withoutOpenGL
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import org.lwjgl.opengl.GL33C.*
import java.nio.file.Path

class OffscreenContextTest {
    private val isLinux = System.getProperty("os.name").startsWith("Linux")

    @Test
    fun `contexts of every kind follow one another in one process`() {
        val kinds = listOf(ContextKind.OSMESA, ContextKind.EGL, ContextKind.OSMESA, ContextKind.EGL, ContextKind.EGL)
        for (kind in kinds) {
            Offscreen.openOrSkip(kind).use { context ->
                assertEquals(kind, context.kind)
                assertTrue(glGetInteger(GL_MAJOR_VERSION) * 10 + glGetInteger(GL_MINOR_VERSION) >= 33)
                assertEquals(GL_CONTEXT_CORE_PROFILE_BIT, glGetInteger(GL_CONTEXT_PROFILE_MASK))
                RenderTarget(1, 1, 0, ColorFormat.RGBA32F).use { target ->
                    glClearColor(0.25f, 0.5f, 2f, 1f)
                    glClear(GL_COLOR_BUFFER_BIT)
                    assertEquals(listOf(0.25f, 0.5f, 2f, 1f), target.readFloats().rgba.toList(), "$kind")
                }
            }
        }
    }

    @Test
    fun `the first kind that works is taken`() {
        assumeTrue(isLinux)
        Offscreen.openOrSkip(ContextKind.OSMESA).close()
        Offscreen.openOrSkip().use { assertEquals(ContextKind.OSMESA, it.kind) }
    }

    @Test
    fun `a window without a display is unavailable, with the cure`() {
        assumeTrue(
            isLinux && listOf("DISPLAY", "WAYLAND_DISPLAY").all { System.getenv(it).isNullOrEmpty() },
            "needs a machine without display",
        )
        val message = assertThrows<ContextUnavailable> { OffscreenContext.open(ContextKind.WINDOW) }.message.orEmpty()
        assertTrue("no display" in message && "xvfb-run" in message, message)
        Offscreen.openOrSkip().close()
    }

    @Test
    fun `without libraries every kind is named with its reason and its cure`(
        @TempDir folder: Path,
    ) {
        assumeTrue(isLinux)
        val hidden = withoutOpenGL(folder)
        val process = CgaProcess.cga("render", "--size", "8x8", "--out", "none.png", directory = folder, env = hidden)
        assertEquals(2, process.exitCode, process.toString())
        val lines = process.err.lines()
        for ((kind, cure) in mapOf("osmesa" to "libosmesa6", "egl" to "libegl1 libgl1-mesa-dri", "window" to "xvfb-run")) {
            assertTrue(lines.any { "$kind: " in it && cure in it }, "$kind\n$process")
        }
        assertTrue("Exception" !in process.err, process.toString())
    }

    @Test
    fun `EGL without a driver is unavailable, with the cure`(
        @TempDir folder: Path,
    ) {
        assumeTrue(isLinux)
        Offscreen.openOrSkip(ContextKind.EGL).close()
        // libglvnd, which libEGL.so.1 is, looks for the drivers' descriptions there.
        val env = mapOf("__EGL_VENDOR_LIBRARY_DIRS" to "$folder")
        val process = CgaProcess.cga("render", "--size", "8x8", "--context", "egl", directory = folder, env = env)
        assertEquals(2, process.exitCode, process.toString())
        assertTrue("cga: egl: " in process.err && "apt-get install libegl1 libgl1-mesa-dri" in process.err, process.toString())
        assertTrue("Exception" !in process.err, process.toString())
    }
}
