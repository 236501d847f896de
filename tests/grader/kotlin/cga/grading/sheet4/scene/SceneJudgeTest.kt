package cga.grading.sheet4.scene

import cga.exercise.game.Step
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SceneJudgeTest {
    @Test
    fun `the reference solution has no mistake`() {
        // Its matrices are floats: positions of 20 units are off by 2e-6, and everything is relative to units.
        SceneJudge.judge(OwnScene.play(Step.FINAL), emptyList()).assertRight(tolerance = 2e-5)
    }

    @Test
    fun `a scene of float matrices that every update multiplies into has no mistake`() {
        // 400 updates, each rounding every element of four products: 400 · 4 · 6e-8 at the very most.
        Rig().verdict().assertRight(tolerance = 1e-4)
    }

    @Test
    fun `the reference before the last steps lacks what they add`() {
        fun named(step: Step) = SceneJudge.judge(OwnScene.play(step), emptyList()).mistakes.map { it.mistake }
        assertEquals(listOf(Mistake.MORE_LIGHTS_MISSING), named(Step.ORBIT))
        assertEquals(listOf(Mistake.ORBIT_MISSING, Mistake.MORE_LIGHTS_MISSING), named(Step.COLOR))
        val point = named(Step.POINT_LIGHT)
        val lacking = listOf(Mistake.SPOT_MISSING, Mistake.ATTENUATION_MISSING, Mistake.COLOR_CONSTANT, Mistake.ORBIT_MISSING)
        assertEquals(lacking + Mistake.MORE_LIGHTS_MISSING, point)
        assertTrue(Mistake.LIGHT_MISSING in named(Step.EMISSION))
    }

    @Test
    fun `no frames are no mistakes, and no points`() {
        val verdict = SceneJudge.judge(emptyList(), emptyList())
        assertEquals(SceneJudge.CHECKS, verdict.checks.map { it.check }.toSet())
        verdict.checks.forEach { assertNull(it.error, it.check.id) }
        assertEquals(emptyList<Mistake>(), verdict.mistakes.map { it.mistake })
    }

    @Test
    fun `a run that ends early leaves unmeasured what it did not reach`() {
        val frames = Rig().play()
        for (count in 1 until frames.size) {
            val verdict = SceneJudge.judge(frames.take(count), emptyList())
            assertEquals(emptyList<Mistake>(), verdict.mistakes.map { it.mistake }, "$count frames\n${verdict.text()}")
            verdict.checks.forEach { check -> assertTrue((check.error ?: 0.0) <= 1e-3) { "$count frames\n${verdict.text()}" } }
        }
        assertNull(SceneJudge.judge(frames.take(6), emptyList())[Check.ORBIT]?.error)
        assertNull(SceneJudge.judge(frames.take(6), emptyList())[Check.POINT_LIGHT_CHILD]?.error)
    }
}
