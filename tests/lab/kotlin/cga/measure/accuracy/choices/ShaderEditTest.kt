package cga.measure.accuracy.choices

import cga.framework.Home
import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Files

class ShaderEditTest {
    @Test
    fun `an edit replaces every match`() {
        assertEquals("b x b", ShaderEdit("scene.frag", "a", "b").applyTo("a x a"))
    }

    @Test
    fun `an edit that matches nothing is an error that names its text`() {
        val message = assertThrows(InputError::class.java) { ShaderEdit("scene.frag", "no such line", "x").applyTo("a") }.message.orEmpty()
        assertTrue("shaders/scene.frag" in message && "no such line" in message) { message }
    }

    @Test
    fun `edited shaders are read while something is made, and are gone afterwards`() {
        val before = Home.resolve("shaders/scene.frag")
        val read =
            EditedHome().use { home ->
                home.with(listOf(ShaderEdit("scene.frag", "void main()", "void other()"))) {
                    Home.resolve("shaders/scene.frag") to Home.read("shaders/scene.frag", "shader").decodeToString()
                }
            }
        assertTrue("void other()" in read.second)
        assertFalse(Files.exists(read.first))
        assertEquals(before, Home.resolve("shaders/scene.frag"))
    }

    /** All edits fit the shaders as they are; that the result is what it says is seen in its error against the truth. */
    @Test
    fun `every choice's edits match`() {
        EditedHome().use { home ->
            for (choice in DrawingChoices.all) {
                for (shot in listOf(choice.timed, choice.compared)) home.with(shot.edits) { }
            }
        }
    }
}
