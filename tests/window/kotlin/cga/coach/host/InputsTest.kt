package cga.coach.host

import cga.coach.Program
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.lwjgl.glfw.GLFW.GLFW_KEY_A
import org.lwjgl.glfw.GLFW.GLFW_KEY_W
import org.lwjgl.glfw.GLFW.GLFW_PRESS
import org.lwjgl.glfw.GLFW.GLFW_RELEASE

class InputsTest {
    private val inputs = Inputs(0.25)

    @Test
    fun `another program is told what the first was told, in its order and at its times`() {
        val first = Diary(inputs)
        inputs.mouse(first, 10.0, 20.0)
        inputs.update(first)
        inputs.key(first, GLFW_KEY_W, 0, GLFW_PRESS, 0)
        repeat(3) { inputs.update(first) }
        inputs.mouse(first, 30.0, 40.0)
        inputs.key(first, GLFW_KEY_W, 0, GLFW_RELEASE, 0)
        inputs.update(first)
        val second = Diary(inputs)
        assertTrue(inputs.replay(second))
        assertEquals(first.lines, second.lines)
        assertEquals(listOf("mouse 10.0 20.0", "update 0.25 false", "key 87 1", "update 0.5 true"), second.lines.take(4))
        assertEquals(1.25, inputs.time)
        assertFalse(inputs.isDown(GLFW_KEY_W))
        inputs.update(second)
        assertEquals("update 1.5 false", second.lines.last())
    }

    @Test
    fun `between two updates only the last place of the mouse is remembered, and that is where it is`() {
        val first = Diary(inputs)
        for (x in 1..3) inputs.mouse(first, x.toDouble(), 0.0)
        assertEquals(3, first.lines.size)
        val second = Diary(inputs)
        inputs.replay(second)
        assertEquals(listOf("mouse 3.0 0.0"), second.lines)
        assertEquals(3.0, inputs.mouseX)
    }

    @Test
    fun `a program that takes too long is told the beginning, and keys that are held stay held`() {
        repeat(1000) { inputs.update(null) }
        inputs.key(null, GLFW_KEY_A, 0, GLFW_PRESS, 0)
        inputs.update(null)
        val slow = object : Silent() {
            override fun update(dt: Float, t: Float) = Thread.sleep(5)
        }
        assertFalse(inputs.replay(slow))
        assertEquals(1001 * 0.25, inputs.time)
        assertTrue(inputs.isDown(GLFW_KEY_A))
    }

    @Test
    fun `what is forgotten is not told again`() {
        inputs.key(null, GLFW_KEY_A, 0, GLFW_PRESS, 0)
        inputs.update(null)
        inputs.forget()
        val diary = Diary(inputs)
        inputs.replay(diary)
        assertEquals(emptyList<String>(), diary.lines)
        assertEquals(0.0, inputs.time)
    }

    private class Diary(private val inputs: Inputs) : Silent() {
        val lines = ArrayList<String>()

        override fun update(dt: Float, t: Float) {
            lines += "update $t ${inputs.isDown(GLFW_KEY_W)}"
        }

        override fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
            lines += "key $key $action"
        }

        override fun onMouseMove(xpos: Double, ypos: Double) {
            lines += "mouse $xpos $ypos"
        }
    }
}

/** A program that does nothing. */
internal open class Silent : Program {
    override fun start() = Unit

    override fun update(dt: Float, t: Float) = Unit

    override fun render(dt: Float, t: Float) = Unit

    override fun onKey(key: Int, scancode: Int, action: Int, mode: Int) = Unit

    override fun onMouseMove(xpos: Double, ypos: Double) = Unit

    override fun onMouseButton(button: Int, action: Int, mode: Int) = Unit

    override fun onMouseScroll(xoffset: Double, yoffset: Double) = Unit

    override fun shutdown() = Unit
}
