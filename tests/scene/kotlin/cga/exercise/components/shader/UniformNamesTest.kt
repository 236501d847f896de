package cga.exercise.components.shader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class UniformNamesTest {
    @Test
    fun `the distance counts letters added, dropped and replaced`() {
        assertEquals(0, UniformNames.distance("view", "view"))
        assertEquals(4, UniformNames.distance("", "view"))
        assertEquals(4, UniformNames.distance("view", ""))
        assertEquals(1, UniformNames.distance("view", "views"))
        assertEquals(1, UniformNames.distance("view", "vie"))
        assertEquals(1, UniformNames.distance("view", "vied"))
        assertEquals(3, UniformNames.distance("kitten", "sitting"))
        assertEquals(3, UniformNames.distance("sitting", "kitten"))
    }

    @Test
    fun `an unknown name is answered with the nearest`() {
        val known = listOf("projection", "emissiveTint", "pointLight[0].position", "pointLight[0].color", "spotLight[0].color")
        for ((wrong, right) in listOf(
            "emisiveTint" to "emissiveTint",
            "projektion" to "projection",
            "pointLight[0].colour" to "pointLight[0].color",
            "pointlight[0].positon" to "pointLight[0].position",
        )) {
            val message = UniformNames.unknown(wrong, known, "a.vert + b.frag")
            assertTrue(message.endsWith("Did you mean $right?")) { message }
            assertTrue("uniform $wrong " in message && "a.vert + b.frag" in message) { message }
            assertEquals(1, message.lines().size)
        }
    }

    @Test
    fun `a program without uniforms has no nearest`() {
        assertTrue("no uniforms" in UniformNames.unknown("view", emptyList(), "a.vert + b.frag"))
    }
}
