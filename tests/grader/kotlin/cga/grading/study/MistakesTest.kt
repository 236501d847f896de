package cga.grading.study

import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.extension.ExtendWith

@ExtendWith(Offscreen::class)
@Slow
class MistakesTest {
    private val scene = TestScene()

    @TestFactory
    fun `a mistake is named`(): List<DynamicTest> = MistakeCases(scene).all.map { case -> dynamicTest(case.name) { check(case) } }

    private fun check(case: MistakeCases.Case) {
        val capture = SceneCapture.of(case.vertex, case.fragment, scene) { model -> case.sent(model, scene.uniforms(model)) }
        val found = ProgramDeviations.of(capture.study())
        assertEquals(case.expected, found.map { it.mistake }.toSet()) {
            found.joinToString("\n") { "${it.mistake} at ${it.where}: fit ${it.fit}, difference ${it.difference}" }
        }
    }
}
