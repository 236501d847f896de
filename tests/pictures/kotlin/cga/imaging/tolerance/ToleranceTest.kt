package cga.imaging.tolerance

import cga.framework.InputError
import cga.imaging.Comparison
import cga.imaging.Severity
import cga.imaging.Severity.FAIL
import cga.imaging.Severity.PASS
import cga.imaging.Severity.WARN
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.writeText

/** What the trees say, at their bounds and on either side of them. */
class ToleranceTest {
    @TempDir
    private lateinit var folder: Path

    @Test
    fun `a value that equals its bound is within it, and the next step is not`() {
        for (step in 1..30) {
            val tolerance = tolerance("""{"metric": "max", "fail": "$step/255", $WHY}""")
            assertSeverity(PASS, tolerance, against(100 + step))
            assertSeverity(FAIL, tolerance, against(100 + step + 1))
            assertSeverity(FAIL, tolerance, against(100 - step - 1))
        }
    }

    @Test
    fun `warn comes before fail, and either may be left away`() {
        val both = tolerance("""{"metric": "max", "warn": "1/255", "fail": "2/255", $WHY}""")
        assertEquals(listOf(PASS, WARN, FAIL), (1..3).map { both.judge(against(100 + it)).severity })
        assertSeverity(WARN, tolerance("""{"metric": "max", "warn": "1/255", $WHY}"""), against(255))
    }

    @Test
    fun `the message has metric, value, bound, place, both colours, reason and machine`() {
        val message = tolerance("""{"metric": "max", "fail": "2/255", $WHY}""").judge(against(107)).messages.single()
        val values = "expected 100  100  100, actual 107  107  107"
        for (part in listOf("max 7/255", "2/255", "(0, 0)", values, "the reason", "the machine")) {
            assertTrue(part in message) { "no \"$part\" in: $message" }
        }
        val windowed = tolerance("""{"metric": "window", "size": 4, "fail": 0, $WHY}""")
            .judge(
                Comparison(
                    bytes(),
                    bytes().also {
                        it.image.rgba.fill(
                            101,
                            4 * 32 * 28,
                        )
                    },
                ),
            ).messages
            .single()
        assertTrue("worst 4x4 window 1/255" in windowed && "(0, 28)" in windowed, windowed)
    }

    @Test
    fun `every metric has its own value`() {
        // 64 of 1024 pixels, two rows of 32, are 8/255 brighter in all three channels.
        val comparison = against(108, pixels = 64)
        assertBound(comparison, """"metric": "max"""", 8.0 / 255)
        assertBound(comparison, """"metric": "differing"""", 64.0 / 1024)
        // The root of the mean of the squares: 8/255 · √(1/16).
        assertBound(comparison, """"metric": "rmse"""", 2.0 / 255)
        assertBound(comparison, """"metric": "window", "size": 4""", 8.0 / 255 * 8 / 16)
        assertBound(comparison, """"metric": "flip mean"""", comparison.flip.mean)
        assertBound(comparison, """"metric": "flip percentile", "percent": 97.5""", comparison.flip.percentile(0.975).toDouble())
    }

    @Test
    fun `of psnr more is better`() {
        // 20·log10(255/8) = 30.07 dB for a picture that is 8/255 off everywhere.
        val comparison = against(108, pixels = 1024)
        assertSeverity(PASS, tolerance("""{"metric": "psnr", "warn": 30.06, "fail": 30, $WHY}"""), comparison)
        assertSeverity(WARN, tolerance("""{"metric": "psnr", "warn": 30.08, "fail": 30, $WHY}"""), comparison)
        assertSeverity(FAIL, tolerance("""{"metric": "psnr", "fail": 30.08, $WHY}"""), comparison)
    }

    @Test
    fun `all is as severe as its worst, any as its best`() {
        val (pass, warn, fail) =
            listOf(""""fail": "9/255"""", """"warn": "1/255"""", """"fail": "1/255"""").map { """{"metric": "max", $it, $WHY}""" }
        val comparison = against(105)
        for ((rules, all, any) in listOf(
            Triple(listOf(pass, pass), PASS, PASS), Triple(listOf(pass, warn), WARN, PASS), Triple(listOf(fail, warn), FAIL, WARN),
            Triple(listOf(warn, fail), FAIL, WARN), Triple(listOf(fail, fail), FAIL, FAIL), Triple(listOf(fail, pass), FAIL, PASS),
        )) {
            assertSeverity(all, tolerance("""{"all": $rules}"""), comparison)
            assertSeverity(any, tolerance("""{"any": $rules}"""), comparison)
        }
        assertSeverity(PASS, tolerance("""{"all": [$pass, {"any": [$fail, $pass]}]}"""), comparison)
        assertEquals(2, tolerance("""{"any": [$fail, $fail]}""").judge(comparison).messages.size)
        val messages = tolerance("""{"all": [$warn, $fail]}""").judge(comparison).messages
        assertEquals(2, messages.size)
    }

    @Test
    fun `equal pictures pass whatever the bounds are`() {
        assertSeverity(PASS, tolerance("""{"metric": "psnr", "fail": 1000, $WHY}"""), Comparison(bytes(), bytes()))
    }

    @Test
    fun `float pictures have a tree of their own, in their own unit`() {
        val file =
            folder.resolve("both.json").also {
                it.writeText("""{"byte": {"metric": "max", "fail": 0, $WHY}, "float": {"metric": "max", "fail": 0.5, $WHY}}""")
            }
        val tolerance = Tolerance.read(file)
        assertSeverity(PASS, tolerance, Comparison(floats(), floats(1.5f, 1)))
        assertTrue("max 0.75 is" in tolerance.judge(Comparison(floats(), floats(1.75f, 1))).messages.single())
        assertSeverity(FAIL, tolerance, against(101))
        val bytesOnly = tolerance("""{"metric": "max", "fail": 0, $WHY}""")
        val message = assertThrows<InputError> { bytesOnly.judge(Comparison(floats(), floats(2f, 1))) }.message.orEmpty()
        assertTrue("\"float\"" in message, message)
    }

    /** The value is exactly [value]: a bound a millionth below it fails, one a millionth above passes. */
    private fun assertBound(
        comparison: Comparison,
        metric: String,
        value: Double,
    ) {
        assertSeverity(FAIL, tolerance("""{$metric, "fail": ${value * (1 - 1e-6)}, $WHY}"""), comparison)
        assertSeverity(PASS, tolerance("""{$metric, "fail": ${value * (1 + 1e-6)}, $WHY}"""), comparison)
    }

    private fun assertSeverity(
        expected: Severity,
        tolerance: Tolerance,
        comparison: Comparison,
    ) {
        val verdict = tolerance.judge(comparison)
        assertEquals(expected, verdict.severity, "${verdict.messages}")
        assertEquals(expected == PASS, verdict.messages.isEmpty(), "${verdict.messages}")
    }

    private fun tolerance(byteRule: String): Tolerance =
        Tolerance.read(folder.resolve("tolerance.json").also { it.writeText("""{"byte": $byteRule}""") })

    private companion object {
        const val WHY = """"reason": "the reason", "machine": "the machine""""
    }
}
