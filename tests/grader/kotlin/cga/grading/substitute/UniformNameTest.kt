package cga.grading.substitute

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/** Names as students give them: what is said of which light. */
class UniformNameTest {
    @TestFactory
    fun `a name says what it is, and whose`(): List<DynamicTest> =
        listOf(
            Triple("pointLightPos", Part.POSITION, "point"),
            Triple("pointLight.position", Part.POSITION, "point"),
            Triple("point_light_position", Part.POSITION, "point"),
            Triple("lightPositions[2]", Part.POSITION, "2"),
            Triple("lights[2].color", Part.COLOR, "2"),
            Triple("u_lights[2].colour", Part.COLOR, "2"),
            Triple("spotcol", Part.COLOR, "spot"),
            Triple("strahlerFarbe", Part.COLOR, "strahler"),
            Triple("corner3Att", Part.ATTENUATION, "corner3"),
            Triple("punktK", Part.ATTENUATION, "punkt"),
            Triple("spot.direction", Part.DIRECTION, "spot"),
            Triple("scheinwerferRichtung", Part.DIRECTION, "scheinwerfer"),
            Triple("spotInnerCutOff", Part.INNER, "spot"),
            Triple("spotLight.outerCone", Part.OUTER, "spot"),
            Triple("beam.phi", Part.INNER, "beam"),
            Triple("spotAttConst", Part.CONSTANT, "spot"),
            Triple("light1_pos", Part.POSITION, "light1"),
            Triple("pos1", Part.POSITION, "1"),
        ).map { (name, part, owner) ->
            dynamicTest(name) {
                val found = UniformName(name)
                assertEquals(part to owner, found.parts.first() to found.owner)
            }
        }

    @Test
    fun `a word inside of another is none`() {
        assertEquals(emptyList<Part>(), UniformName("shininess").parts)
        assertEquals(emptyList<Part>(), UniformName("texSpec").parts)
        assertEquals(emptyList<Part>(), UniformName("lantern").parts)
    }

    @Test
    fun `words are looked for at their beginning`() {
        assertTrue(UniformName("u_normalMatrix").says("norm"))
        assertFalse(UniformName("denormal").says("norm"))
    }
}
