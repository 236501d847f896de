package cga.measure.golden

import cga.framework.image.ExrFile
import cga.framework.image.PngFile
import cga.imaging.BytePicture
import cga.imaging.FloatPicture
import cga.imaging.Severity
import cga.imaging.report.HtmlReport
import cga.testing.Need
import cga.testing.Offscreen
import cga.testing.Slow
import cga.testing.projectRoot
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assertions.fail
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import java.nio.file.Path
import kotlin.io.path.exists

/** The scene still looks as it was approved: what `./cga golden` says, one test a case. */
@Slow
class GoldenTest {
    @BeforeEach
    fun `there is a context`() = Offscreen.openOrSkip().close()

    @ParameterizedTest(name = "{0}")
    @MethodSource("cases")
    fun `the picture is as it was approved`(case: GoldenCase) {
        val result = GoldenRun().result(case)
        val outcome = result.outcome
        if (outcome.severity == Severity.FAIL) fail<Unit>(describe(result, folder()))
        if (outcome.isSkipped) Need.LLVMPIPE.skip(outcome.messages.joinToString("\n"))
    }

    @Test
    fun `every golden has a case`() {
        assertEquals("", GoldenRun().strays().joinToString("\n") { "${it.name}: ${it.outcome.messages.first()}" })
    }

    @Test
    fun `a case is drawn the same whatever was drawn before it, in any context`() {
        val case = GoldenCases.all.first { it.samples == 0 && !it.float }
        val first = GoldenRun().result(case)
        GoldenRun().result(GoldenCases.all.first { it.float })
        val second = GoldenRun().result(case)
        val pictures = listOf(first, second).map { (it.rendered?.picture as BytePicture).image.rgba.toList() }
        assertEquals(pictures[0], pictures[1])
    }

    @Test
    fun `a failure leaves the picture and a page, and names both`(
        @TempDir folder: Path,
    ) {
        for (case in listOf(GoldenCases.all.first(), GoldenCases.all.first { it.float })) {
            val result = GoldenRun().result(case)
            val message = describe(result, folder)
            for (name in listOf("${case.name}-actual.${if (case.float) "exr" else "png"}", "${case.name}.html")) {
                assertTrue(folder.resolve(name).exists() && "${folder.resolve(name)}" in message, "$name: $message")
            }
        }
    }

    private fun folder(): Path = projectRoot.resolve("build/golden").also { it.mkdirs() }.toPath()

    /** The messages, and where to look; writes what there is to see. */
    private fun describe(
        result: GoldenResult,
        folder: Path,
    ): String {
        val page = folder.resolve("${result.name}.html")
        HtmlReport.write(result.name, listOf(result.reportCase()), page)
        val actual =
            when (val picture = result.rendered?.picture) {
                is BytePicture -> folder.resolve("${result.name}-actual.png").also { PngFile.write(picture.image, it) }
                is FloatPicture -> folder.resolve("${result.name}-actual.exr").also { ExrFile.write(picture.image, it) }
                null -> null
            }
        return (listOf(result.name) + result.outcome.messages + listOfNotNull("see $page", actual?.let { "and $it" })).joinToString("\n")
    }

    private companion object {
        @JvmStatic
        fun cases(): List<GoldenCase> = GoldenCases.all
    }
}
