package cga.grading.study

import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.extension.ExtendWith

@ExtendWith(Offscreen::class)
@Slow
class LentColorTest {
    private fun lent(fragment: String) = SceneCapture.of(CourseShaders.VERTEX, fragment).study().lent

    private fun edited(
        old: String,
        new: String,
    ): String {
        assertTrue(old in CourseShaders.FRAGMENT)
        return CourseShaders.FRAGMENT.replace(old, new)
    }

    @Test
    fun `a headlight that shines in the colour of the first light, and by its distance`() {
        val copied =
            edited("* spotLightColor * attenuate(ds, spotLightAttenuation)", "* pointLightColor * attenuate(dp, pointLightAttenuation)")
        assertEquals(setOf("pointLightColor"), lent(copied))
    }

    @Test
    fun `no colour is lent where all is right, or where the headlight is not there at all`() {
        assertEquals(emptySet<String>(), lent(CourseShaders.FRAGMENT))
        assertEquals(emptySet<String>(), lent(edited("* spotLightColor *", "* 0.0 * spotLightColor *")))
    }
}
