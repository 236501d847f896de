package cga.grading.sheet4.shading

import cga.grading.findings.Mistake
import cga.grading.reading.CaptureReading
import cga.grading.study.CourseShaders
import cga.grading.study.MistakeCases
import cga.grading.study.SceneCapture
import cga.grading.study.TestScene
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

class ShadingTest {
    private val scene = TestScene()

    @TestFactory
    fun `a mistake in a shader is named and nothing else is`(): List<DynamicTest> =
        MistakeCases(scene).all.filter { it.name !in SENT && it.name !in UNCLEAR }.map { case ->
            dynamicTest(case.name) { assertEquals(case.expected, named(case)) }
        }

    @TestFactory
    fun `what is wrong in the numbers sent is no mistake of the shader's`(): List<DynamicTest> =
        MistakeCases(scene).all.filter { it.name in SENT }.map { case ->
            dynamicTest(case.name) { assertEquals(emptySet<Mistake>(), named(case)) }
        }

    @TestFactory
    fun `what is not understood is at least unknown`(): List<DynamicTest> =
        MistakeCases(scene).all.filter { it.name in UNCLEAR }.map { case ->
            dynamicTest(case.name) {
                assertEquals(
                    true,
                    named(case).any {
                        it in case.expected || it == Mistake.UNKNOWN ||
                            it == Mistake.SPECULAR_NOT_CONED
                    },
                )
            }
        }

    @Test
    fun `every list here is of cases that there are`() {
        assertEquals(emptySet<String>(), SENT + UNCLEAR - MistakeCases(scene).all.map { it.name }.toSet())
    }

    @Test
    fun `the line of a mistake is where it is written`() {
        val wrong = "k.x + k.y * d + k.z * d"
        val fragment = CourseShaders.FRAGMENT.replace("k.x + k.y * d + k.z * d * d", wrong)
        val found = Shading(CaptureReading(SceneCapture.of(CourseShaders.VERTEX, fragment, scene))).deviations
        val line = 1 + fragment.lines().indexOfFirst { wrong in it }
        assertEquals(setOf(Mistake.ATTENUATION_LINEAR to line), found.map { it.mistake to it.line?.line }.toSet())
    }

    private fun named(case: MistakeCases.Case): Set<Mistake> {
        val capture = SceneCapture.of(case.vertex, case.fragment, scene) { model -> case.sent(model, scene.uniforms(model)) }
        return Shading(CaptureReading(capture)).deviations.map { it.mistake }.toSet()
    }

    private companion object {
        /** What is wrong shows in the places, angles and textures that these are given: the scene's to judge. */
        val SENT = setOf(
            "lights through the model matrix", "lights through model and view", "lights through the view twice",
            "lights through the camera's matrix",
            "maps swapped", "emission and diffuse map swapped", "all three maps at the next one's place", "sampler left at unit 0",
            "cone by the sheet's letters", "inner and outer swapped", "cosines sent as angles", "cosine twice",
            "cosines written into the shader as angles", "degrees sent", "other degrees sent", "degrees written into the shader",
            "an axis that is too short for full light", "an axis that is too long", "cosines of degrees", "only the direction never sent",
            "cosines never sent", "cone never sent",
        )

        /** Read as something unknown, or with something unknown beside the mistake. */
        val UNCLEAR = setOf(
            "the headlight a second time without its cone", "the cosine of the cosine between axis and light", "radians made of radians",
            "normals moved with the model", "the exponent at the diffuse cosine", "emission in the light's bracket",
            "emission beside the diffuse texture", "F twice",
            "normals as they come, stretched by the model's scale, in cosines that are cut off at 1",
        )
    }
}
