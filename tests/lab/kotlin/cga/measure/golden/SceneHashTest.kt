package cga.measure.golden

import cga.exercise.game.Scene
import cga.exercise.game.ScriptedScene
import cga.exercise.game.Step
import cga.framework.Frame
import cga.framework.SpecularModel
import org.joml.Matrix4d
import org.joml.Vector3f
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test

/** The hash of a scene's part changes with that part and with no other. */
class SceneHashTest {
    private val before = hash()

    @Test
    fun `the same scene has the same hashes`() {
        assertEquals(before, hash())
        assertEquals(5, before.values.toSet().size)
    }

    @Test
    fun `each part is told by its name`() {
        assertChanged(hash { ambient = Vector3f(0f, 0f, 1e-9f) }, "scene shading")
        assertChanged(hash { gamma = 1.01f }, "scene shading")
        assertChanged(hash { specularModel = SpecularModel.PHONG }, "scene shading")
        assertChanged(hash(mouse = 1.0), "scene camera")
        assertChanged(hash(t = 5.31), "scene lights", "scene placement")
        // The mouse's step and the lights' counts: the earlier one has no corner lights and another specular model.
        assertChanged(hash(step = Step.ORBIT), "scene lights", "scene shading")
    }

    @Test
    fun `the last bit of a double is no change, that of a float is one`() {
        val frame = scene().scene.frame()

        fun withView(factor: Double) = SceneHash.of(frame.withView(Matrix4d(frame.view).also { it.m30(it.m30() + factor) }))
        assertEquals(before, withView(0.0))
        // The camera's z in view space is about 4: half an ulp of it as a float is 2.4e-7, and as a double 4.4e-16.
        assertEquals(before, SceneHash.of(frame.withView(Matrix4d(frame.view).also { it.m32(Math.nextUp(it.m32())) })))
        assertNotEquals(before, SceneHash.of(frame.withView(Matrix4d(frame.view).also { it.m32(it.m32() + 1e-6) })))
    }

    private fun hash(
        t: Double = 5.3,
        mouse: Double = 0.0,
        step: Step = Step.FINAL,
        change: Scene.() -> Unit = {},
    ): Map<String, String> = SceneHash.of(scene(t, mouse, step).scene.apply(change).frame())

    private fun scene(
        t: Double = 5.3,
        mouse: Double = 0.0,
        step: Step = Step.FINAL,
    ) = ScriptedScene(16, 9, step).apply {
        moveMouseTo(mouse)
        advanceTo(t)
    }

    private fun Frame.withView(view: Matrix4d) =
        Frame(view, projection, ambient, specularModel, gamma, lights, draws)

    private fun assertChanged(
        after: Map<String, String>,
        vararg parts: String,
    ) = assertEquals(parts.toSet(), before.keys.filter { before[it] != after[it] }.toSet())
}
