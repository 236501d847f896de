package cga.exercise.game

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.lwjgl.glfw.GLFW.*

class DriveScriptTest {
    @Test
    fun `parts follow each other`() {
        val script = DriveScript.parse("W 2, WA 0.5")
        assertEquals(2.5, script.duration)
        assertEquals("W", script.keysAt(0.0))
        assertEquals("W", script.keysAt(1.999))
        assertEquals("WA", script.keysAt(2.0))
        assertEquals("WA", script.keysAt(2.499))
        assertEquals("", script.keysAt(2.5))
    }

    @Test
    fun `letters are of any case and order, spaces optional`() {
        val script = DriveScript.parse("  dsaw1 ,Wd   2 ")
        assertEquals("WASD", script.keysAt(0.5))
        assertEquals("WD", script.keysAt(1.5))
        assertEquals(3.0, script.duration)
    }

    @Test
    fun `a part without letters holds nothing, one of no time neither`() {
        val script = DriveScript.parse("1.5, W 0, S 1")
        assertEquals("", script.keysAt(1.0))
        assertEquals("S", script.keysAt(1.5))
    }

    @Test
    fun `keys that do not drive are never held`() {
        assertEquals(false, DriveScript.parse("WASD 9").isDown(GLFW_KEY_B, 1.0))
    }

    @Test
    fun `hands off is the empty script`() {
        assertEquals(0.0, DriveScript.NONE.duration)
        assertEquals("", DriveScript.NONE.keysAt(0.0))
    }

    @Test
    fun `what it cannot read it names, with an example`() {
        for ((text, part) in listOf(
            "" to "",
            "W" to "W",
            "W 1, X 2" to "X 2",
            "W -1" to "W -1",
            "W 1;A 2" to "W 1;A 2",
            "W 1,,A 2" to "",
            "W 1e3" to "W 1e3",
            "W NaN" to "W NaN",
            "2 W" to "2 W",
        )) {
            val error = assertThrows<InputError>(text) { DriveScript.parse(text) }
            val message = error.message.orEmpty()
            assertTrue("cannot read \"$part\"" in message && "W 2, WA 0.5" in message) { message }
            assertEquals(1, message.lines().size)
        }
    }

    @Test
    fun `more than an hour is too long`() {
        assertEquals(3600.0, DriveScript.parse("W 3599, 1").duration)
        for (text in listOf("W 3600.5", "W 3600, A 0.1")) {
            val error = assertThrows<InputError>(text) { DriveScript.parse(text) }
            assertTrue("3600" in error.message.orEmpty()) { error.message }
        }
    }

    private fun DriveScript.keysAt(time: Double) =
        listOf("W" to GLFW_KEY_W, "A" to GLFW_KEY_A, "S" to GLFW_KEY_S, "D" to GLFW_KEY_D)
            .filter { (_, key) -> isDown(key, time) }
            .joinToString("") { it.first }
}
