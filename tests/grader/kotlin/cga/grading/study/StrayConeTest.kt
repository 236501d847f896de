package cga.grading.study

import cga.grading.findings.Check
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.assertNear
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

@ExtendWith(Offscreen::class)
@Slow
class StrayConeTest {
    private val scene = TestScene()

    private fun study(fragment: String) = SceneCapture.of(CourseShaders.VERTEX, fragment, scene).study()

    @Test
    fun `a cone by the vector to another light costs the cone, its axis and edges are found and the light fades as it should`() {
        val study = study(CourseShaders.FRAGMENT.edited("* cone(ls)", "* cone(lp)"))
        val spot = study.shining.single { it.cone != null }
        assertTrue(spot.hasStrayCone)
        val cone = spot.cone ?: throw AssertionError("no cone")
        assertNear(scene.inner, cone.inner, 1e-3, "inner")
        assertNear(scene.outer, cone.outer, 1e-3, "outer")
        // Strengths are good to 1e-6, relative.
        assertNear(Vector3d(0.5, 0.05, 0.01), Vector3d(spot.attenuation?.k ?: throw AssertionError("it fades by no law")), 1e-3, "K")
        assertEquals(listOf(Check.CONE), ConeDeviations.of(spot, emptyList()).map { it.check })
        assertEquals(emptyList<Deviation>(), LightDeviations.of(spot, study))
    }

    @Test
    fun `a cone that is right is not one`() {
        assertTrue(study(CourseShaders.FRAGMENT).shining.none { it.hasStrayCone })
    }
}
