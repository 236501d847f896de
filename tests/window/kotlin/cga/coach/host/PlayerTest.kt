package cga.coach.host

import cga.coach.numbers.Numbers
import cga.framework.RenderTarget
import cga.inspect.soak.GlObjects
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith
import org.lwjgl.opengl.GL33C.*

/** Programs that students may well write, one after the other. */
@ExtendWith(Offscreen::class)
@Slow
class PlayerTest {
    private val numbers = Numbers()
    private val watch = GlWatch(numbers).apply { start() }
    private val player = Player(watch, Inputs(0.01))

    @AfterEach
    fun close() {
        player.close()
        numbers.close()
    }

    @Test
    fun `of two hundred programs that delete nothing no objects are left but the last one's`() {
        val before = GlObjects.count()
        replace(Leaking())
        val one = GlObjects.count() - before
        assertTrue(one >= 6) { "$one objects" }
        repeat(200) { replace(Leaking()) }
        assertEquals(one, GlObjects.count() - before)
        assertEquals(one, player.objectCount)
        player.close()
        assertEquals(before, GlObjects.count())
    }

    @Test
    fun `a program that does not start changes nothing, and file and line are told`() {
        val good = Filling(0.25f)
        replace(good)
        val before = GlObjects.count()
        val trouble = player.replace(SIDE, SIDE, ::isOurs) {
            object : Silent() {
                override fun start() {
                    glGenTextures()
                    glEnable(GL_SCISSOR_TEST)
                    error("no motorcycle")
                }
            }
        }
        val line = trouble?.lines.orEmpty()
        assertTrue(line.first() == "IllegalStateException: no motorcycle" && Regex("""PlayerTest\.kt:\d+""").matches(line[1])) { "$line" }
        assertTrue(player.program === good && !glIsEnabled(GL_SCISSOR_TEST))
        assertEquals(before, GlObjects.count())
    }

    @Test
    fun `a program starts with OpenGL as it is at the beginning, whatever the one before has set`() {
        replace(
            object : Silent() {
                override fun start() {
                    glEnable(GL_DEPTH_TEST)
                    glDepthMask(false)
                    glColorMask(true, false, true, true)
                    glClearColor(1f, 1f, 1f, 1f)
                }
            },
        )
        var found = ""
        replace(
            object : Silent() {
                override fun start() {
                    val mask = IntArray(4).also { glGetIntegerv(GL_COLOR_WRITEMASK, it) }
                    found = "${glIsEnabled(GL_DEPTH_TEST)} ${glGetBoolean(GL_DEPTH_WRITEMASK)} ${mask.toList()}"
                }
            },
        )
        assertEquals("false true [1, 1, 1, 1]", found)
    }

    @Test
    fun `a shader that is refused is told with its line, and with the one before that may lack its semicolon`() {
        val trouble = player.replace(SIDE, SIDE, ::isOurs) {
            object : Silent() {
                override fun start() {
                    val shader = glCreateShader(GL_FRAGMENT_SHADER)
                    glShaderSource(shader, "#version 330 core\nout vec4 c;\nvoid main() {\n    float a = 1.0\n    c = vec4(a);\n}\n")
                    glCompileShader(shader)
                    error(glGetShaderInfoLog(shader))
                }
            }
        }
        val text = trouble?.text.orEmpty()
        assertTrue(
            ":5: " in text && "    c = vec4(a);" in text && "4" in text.substringAfter(":5: ") && "    float a = 1.0" in text,
        ) { text }
    }

    @Test
    fun `a program that throws in every second picture leaves the last good one on the screen, and says so once`() {
        var pictures = 0
        replace(
            object : Silent() {
                override fun render(dt: Float, t: Float) {
                    pictures++
                    glClearColor(if (pictures % 2 == 0) 1f else 0.5f, 0f, 0f, 1f)
                    glClear(GL_COLOR_BUFFER_BIT)
                    if (pictures > 10 && pictures % 2 == 0) error("every second")
                }
            },
        )
        assertNull(player.trouble)
        repeat(20) { player.render(0f, SIDE, SIDE) }
        assertTrue("every second" in player.trouble?.text.orEmpty())
        // The last of them threw after it had cleared; what is seen is the one before.
        assertEquals(0, pictures % 2)
        val pixel = FloatArray(4).also { glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, it) }
        assertEquals(0.5f, pixel[0], 1f / 255)
        replace(Filling(0.25f))
        assertNull(player.trouble)
    }

    @Test
    fun `errors of OpenGL, objects made in every picture and a render that draws nothing are told with their lines`() {
        replace(
            object : Silent() {
                override fun render(dt: Float, t: Float) {
                    glEnable(GL_TEXTURE_2D)
                    glGenTextures()
                }
            },
        )
        repeat(400) { player.render(0f, SIDE, SIDE) }
        val remarks = player.remarks.map { it.lines.joinToString() }
        assertEquals(3, remarks.size) { "$remarks" }
        assertTrue(Regex("""glEnable: GL_INVALID_ENUM, PlayerTest\.kt:\d+""").matches(remarks[0])) { remarks[0] }
        assertTrue(Regex("""glGenTextures, PlayerTest\.kt:\d+""").matches(remarks[2])) { remarks[2] }
        assertNull(player.trouble)
        glGetError()
    }

    @Test
    fun `a shader that loops for long is not shown`() {
        RenderTarget(SIDE, SIDE).use { target ->
            target.bind()
            val trouble = player.replace(SIDE, SIDE, ::isOurs) {
                object : Silent() {
                    override fun render(dt: Float, t: Float) = Thread.sleep(1100)
                }
            }
            assertTrue(trouble != null)
            assertFalse(glIsEnabled(GL_SCISSOR_TEST))
            glBindFramebuffer(GL_FRAMEBUFFER, 0)
        }
    }

    private fun replace(program: Silent) = assertNull(player.replace(SIDE, SIDE, ::isOurs) { program }?.text)

    private fun isOurs(name: String) = name.startsWith("cga.coach.host.PlayerTest")

    private class Filling(private val red: Float) : Silent() {
        override fun render(dt: Float, t: Float) {
            glClearColor(red, 0f, 0f, 1f)
            glClear(GL_COLOR_BUFFER_BIT)
        }
    }

    private class Leaking : Silent() {
        override fun start() {
            glBindTexture(GL_TEXTURE_2D, glGenTextures())
            glBindBuffer(GL_ARRAY_BUFFER, glGenBuffers())
            glBindVertexArray(glGenVertexArrays())
            glBindFramebuffer(GL_FRAMEBUFFER, glGenFramebuffers())
            glBindRenderbuffer(GL_RENDERBUFFER, glGenRenderbuffers())
            glBindFramebuffer(GL_FRAMEBUFFER, 0)
            glCreateProgram()
            glCreateShader(GL_VERTEX_SHADER)
        }
    }

    private companion object {
        const val SIDE = 32
    }
}
