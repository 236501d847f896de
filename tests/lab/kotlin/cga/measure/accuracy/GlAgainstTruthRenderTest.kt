package cga.measure.accuracy

import cga.exercise.game.Step
import cga.testing.Need
import cga.testing.Offscreen
import cga.testing.Slow
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource

/** Every step drawn by OpenGL into a float target, against the reference; docs/accuracy.md derives the bounds. */
@Slow
class GlAgainstTruthRenderTest {
    @ParameterizedTest
    @EnumSource(Step::class)
    fun `both show the same triangle, but for pixels on an edge`(step: Step) {
        val figure = figures.first { it.step == step && it.group == TexelGroup.MINIFIED }
        // OpenGL rounds corners to 1/256 of a pixel, and a centre nearer to an edge than that may fall on either side of it: a chance of
        // 1/128 for each edge that runs through the pixel, and few pixels have one.
        assertTrue(figure.agreement > 1 - 1e-3) { "only ${figure.agreement} of all pixels show the same triangle" }
        val strays = figures.filter { it.step == step }.sumOf { it.strays }
        assertEquals(0, strays, "pixels with a triangle that is not there in truth, or hidden")
    }

    @ParameterizedTest
    @EnumSource(Step::class)
    fun `where no texture is minified every pixel is within its bound`(step: Step) = assertBounded(step, TexelGroup.MAGNIFIED)

    @ParameterizedTest
    @EnumSource(Step::class)
    fun `where textures are minified every pixel is within what other mip levels may change`(step: Step) =
        assertBounded(step, TexelGroup.MINIFIED)

    @ParameterizedTest
    @EnumSource(Step::class)
    fun `with the driver's mip levels every pixel is within the bound of floats`(step: Step) {
        if (!figures.all { it.isLlvmpipe }) Need.LLVMPIPE.skip("needs llvmpipe")
        assertBounded(step, TexelGroup.KNOWN_LEVELS)
    }

    @ParameterizedTest
    @EnumSource(Step::class)
    fun `without mip levels every pixel is within the bound of the lighting`(step: Step) = assertBounded(step, TexelGroup.FIRST_LEVEL)

    @Test
    fun `a table has a line for each picture, and a cell for every column`() {
        val table = GlAgainstTruth.table(figures)
        val lines = table.lines().filter { it.startsWith("|") }
        assertTrue(lines.size >= 2 + Step.entries.size) { table }
        assertEquals(setOf(lines[0].count { it == '|' }), lines.map { line -> line.count { it == '|' } }.toSet())
    }

    @Test
    fun `the report has a place for the tables, with tables of this form in it`() {
        val report = java.io.File("docs/accuracy.md").readText()
        val content = report.substringAfter("<!-- table:gl-against-truth -->\n").substringBefore("\n<!-- end -->")
        val header = GlAgainstTruth.table(figures).lines().first { it.startsWith("|") }
        assertTrue(header in content.lines()) { content }
        for (marker in listOf("table:hard-cases", "table:matrices", "table:choices", "plot:choices")) {
            assertEquals(2, report.split("<!-- $marker -->\n").size, marker)
        }
    }

    private fun assertBounded(
        step: Step,
        group: TexelGroup,
    ) {
        val some = figures.filter { it.step == step && it.group == group }
        assertEquals(FILTERINGS.size, some.size)
        for (figure in some) {
            assertEquals(0, figure.unbounded, "$figure")
            assertTrue(figure.tightness <= 1) { "$figure" }
        }
    }

    companion object {
        private val FILTERINGS = listOf(TextureFiltering.BYTES, TextureFiltering.FLOATS)
        private lateinit var figures: List<GlFigure>

        @BeforeAll
        @JvmStatic
        fun `OpenGL draws`() {
            Offscreen.openOrSkip().close()
            figures = GlAgainstTruth.measure(filterings = FILTERINGS)
        }
    }
}
