package cga.grading.study

import cga.grading.findings.Check
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

@ExtendWith(Offscreen::class)
@Slow
class LongConeTest {
    private fun study(fragment: String) = SceneCapture.of(CourseShaders.VERTEX, fragment).study()

    @Test
    fun `a cone by the vector to the light at its full length costs the cone, and its light still fades by its law`() {
        assertTrue("* cone(ls)" in CourseShaders.FRAGMENT)
        val study = study(CourseShaders.FRAGMENT.replace("* cone(ls)", "* cone(ls * ds)"))
        val spot = study.shining.single { it.cone != null }
        assertTrue(spot.hasLongCone)
        val k = spot.attenuation?.k ?: throw AssertionError("it fades by no law")
        // Strengths are good to 1e-6, relative, and the colour is a factor of all three.
        assertEquals(0.05 / 0.5, k.y() / k.x(), 1e-3)
        assertEquals(0.01 / 0.5, k.z() / k.x(), 1e-3)
        val checks = ConeDeviations.of(spot, emptyList()).map { it.check }
        assertEquals(listOf(Check.CONE), checks)
        assertEquals(emptyList<Deviation>(), LightDeviations.of(spot, study))
    }

    @Test
    fun `a cone that is right is not one`() {
        assertTrue(study(CourseShaders.FRAGMENT).shining.none { it.hasLongCone })
    }
}
