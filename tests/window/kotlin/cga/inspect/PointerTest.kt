package cga.inspect

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.lwjgl.glfw.GLFW.*

class PointerTest {
    private val pointer = Pointer()

    @Test
    fun `with the panel closed every movement turns, the first only says where it starts`() {
        for (x in listOf(700.0, 710.0, 690.5)) pointer.move(x, false)
        assertEquals(-9.5, pointer.orbitX)
    }

    @Test
    fun `with the panel open only the right button, held down, turns`() {
        pointer.move(100.0, true)
        pointer.move(200.0, true)
        assertEquals(0.0, pointer.orbitX)
        assertFalse(pointer.press(GLFW_MOUSE_BUTTON_RIGHT, false))
        pointer.move(230.0, true)
        pointer.release(GLFW_MOUSE_BUTTON_RIGHT)
        pointer.move(500.0, true)
        assertEquals(30.0, pointer.orbitX)
    }

    @Test
    fun `opening and closing the panel is no movement`() {
        pointer.move(100.0, false)
        pointer.pause()
        pointer.move(640.0, true)
        pointer.pause()
        pointer.move(3.0, false)
        pointer.move(5.0, false)
        assertEquals(2.0, pointer.orbitX)
    }

    @Test
    fun `with the panel closed the left button, held down, moves the divider and turns nothing`() {
        pointer.move(100.0, false)
        assertFalse(pointer.press(GLFW_MOUSE_BUTTON_LEFT, true))
        pointer.move(130.0, false)
        assertTrue(pointer.isDividing)
        assertEquals(listOf(30.0, 0.0), listOf(pointer.movement, pointer.orbitX))
        pointer.release(GLFW_MOUSE_BUTTON_LEFT)
        pointer.move(137.0, false)
        assertEquals(7.0, pointer.orbitX)
    }

    @Test
    fun `a left click picks a pixel, but on the divider it drags that`() {
        assertTrue(pointer.press(GLFW_MOUSE_BUTTON_LEFT, false))
        assertFalse(pointer.isDividing)
        assertFalse(pointer.press(GLFW_MOUSE_BUTTON_LEFT, true))
        assertTrue(pointer.isDividing)
        pointer.release(GLFW_MOUSE_BUTTON_LEFT)
        assertFalse(pointer.isDividing)
    }
}
