package cga.exercise.game

import cga.framework.SpecularModel
import cga.testing.HeldKeys
import cga.testing.assertRefused
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.lwjgl.glfw.GLFW.*

class StepTest {
    private val names = listOf("4.1", "4.2", "4.3", "4.3.4", "4.4", "4.5", "4.6", "4.7")

    @Test
    fun `the steps are called by the sheet's numbers, in its order`() {
        assertEquals(names, Step.entries.map { it.sheet })
        assertSame(Step.BLINN_PHONG, Step.FINAL)
        assertEquals(names.size, Step.entries.map { it.title }.toSet().size)
    }

    @Test
    fun `a step is found by its number alone`() {
        for (step in Step.entries) assertSame(step, Step.of(step.sheet))
        for (unknown in listOf("", "4", "4.8", "4.3.1", "EMISSION", " 4.1")) assertNull(Step.of(unknown))
    }

    @Test
    fun `each has what the one before has, and something more`() {
        for ((before, after) in Step.entries.zipWithNext()) {
            assertTrue(after.parts().containsAll(before.parts())) { "$after lacks some of $before" }
            assertTrue(after.parts().size > before.parts().size) { "$after adds nothing to $before" }
        }
    }

    @Test
    fun `a step's frame holds its part of the scene and no more`() {
        val scene = Scene(HeldKeys()).apply { update(0.0, 1.0) }
        val constant = Vector3f(1f, 0f, 0f)
        val ofPoints = Vector3f(1.0f, 0.5f, 0.1f)
        val ofSpots = Vector3f(0.5f, 0.05f, 0.01f)
        for ((name, points, spots) in listOf(
            Triple("4.1", emptyList(), emptyList()),
            Triple("4.2", listOf(constant), emptyList()),
            Triple("4.3", listOf(constant), listOf(constant)),
            Triple("4.3.4", listOf(ofPoints), listOf(ofSpots)),
            Triple("4.4", listOf(ofPoints), listOf(ofSpots)),
            Triple("4.5", listOf(ofPoints), listOf(ofSpots)),
            Triple("4.6", List(5) { ofPoints }, listOf(ofSpots)),
            Triple("4.7", List(5) { ofPoints }, listOf(ofSpots)),
        ).shuffled()) {
            scene.step = Step.of(name)!!
            val frame = scene.frame()
            assertEquals(points, frame.lights.filter { it.cone == null }.map { it.attenuation }, name)
            assertEquals(spots, frame.lights.filter { it.cone != null }.map { it.attenuation }, name)
            assertEquals(if (name == "4.7") SpecularModel.BLINN_PHONG else SpecularModel.PHONG, frame.specularModel, name)

            val white = Vector3f(1f)
            val colored = name >= "4.4"
            assertEquals(if (colored) Vector3f(0f, 1f, 0f) else white, frame.draws.first().tint, name)
            val tints = frame.draws.drop(1).map { it.tint }.toSet()
            assertEquals(1, tints.size, name)
            assertEquals(!colored, tints.single() == white, name)
            assertTrue(frame.lights.isEmpty() || frame.lights.first().color == tints.single()) { name }
            assertEquals(Vector3f(), frame.ambient, name)
            assertEquals(1f, frame.gamma, name)
        }
    }

    @Test
    fun `the number keys choose the step, B the specular model`() {
        val scene = Scene(HeldKeys(), Step.EMISSION)
        for ((number, step) in Step.entries.withIndex()) {
            scene.press(GLFW_KEY_1 + number)
            assertSame(step, scene.step)
            assertSame(step.specularModel, scene.specularModel)
        }
        scene.press(GLFW_KEY_B)
        assertSame(SpecularModel.PHONG, scene.frame().specularModel)
        scene.press(GLFW_KEY_B)
        assertSame(SpecularModel.BLINN_PHONG, scene.frame().specularModel)
        scene.onKey(GLFW_KEY_B, 0, GLFW_REPEAT, 0)
        scene.onKey(GLFW_KEY_1, 0, GLFW_RELEASE, 0)
        scene.press(GLFW_KEY_9)
        scene.press(GLFW_KEY_0)
        assertEquals(Step.FINAL to SpecularModel.BLINN_PHONG, scene.step to scene.specularModel)
    }

    @Test
    fun `a new scene starts at its step`() {
        for (step in listOf(Step.EMISSION, Step.SPOT_LIGHT, Step.FINAL)) {
            val frame = Scene(HeldKeys(), step).frame()
            assertEquals(step.pointLight, frame.lights.any { it.cone == null })
            assertEquals(step.spotLight, frame.lights.any { it.cone != null })
            assertEquals(step.specularModel, frame.specularModel)
        }
    }

    @Test
    fun `ambient light and gamma have their ranges`() {
        val scene = Scene(HeldKeys())
        for (bad in listOf(Vector3f(-1f, 0f, 0f), Vector3f(0f, Float.NaN, 0f), Vector3f(0f, 0f, Float.POSITIVE_INFINITY))) {
            assertRefused(bad) { scene.ambient = bad }
        }
        for (bad in listOf(0f, -1f, Float.MIN_VALUE, Float.NaN, Float.POSITIVE_INFINITY)) assertRefused(bad) { scene.gamma = bad }
        val ambient = Vector3f(0.1f, 0.2f, 0.3f)
        scene.ambient = ambient
        scene.gamma = 2.2f
        ambient.set(9f)
        assertEquals(Vector3f(0.1f, 0.2f, 0.3f), scene.frame().ambient)
        assertEquals(2.2f, scene.frame().gamma)
    }

    private fun Step.parts(): Set<String> =
        mapOf(
            "point light" to pointLight,
            "spotlight" to spotLight,
            "attenuation" to attenuation,
            "colour" to color,
            "orbit" to turnsWithMouse,
            "corner lights" to cornerLights,
            "Blinn-Phong" to (specularModel == SpecularModel.BLINN_PHONG),
        ).filterValues { it }.keys

    private fun Scene.press(key: Int) = onKey(key, 0, GLFW_PRESS, 0)
}
