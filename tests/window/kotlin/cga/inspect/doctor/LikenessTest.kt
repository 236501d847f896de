package cga.inspect.doctor

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class LikenessTest {
    @Test
    fun `a letter, a word in common and the member of the same struct make names alike, others are not`() {
        val alike = listOf(
            "emissiveTint" to "tint",
            "light.color" to "light.colour",
            "specularColor" to "specColor",
            "view_matrix" to "viewMatrix",
        )
        for ((a, b) in alike) assertTrue(Likeness.distance(a, b) < 0.5) { "$a $b ${Likeness.distance(a, b)}" }
        val unlike = listOf("light.color" to "light.position", "ambient" to "shininess", "k" to "tint", "spot.direction" to "spot.cone")
        for ((a, b) in unlike) assertTrue(Likeness.distance(a, b) > 0.5) { "$a $b ${Likeness.distance(a, b)}" }
    }
}
