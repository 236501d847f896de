package cga.imaging.tolerance

import cga.framework.InputError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import java.nio.file.Path
import kotlin.io.path.writeText

/** Reading tolerances: each mistake is one message that names the file, the place and the cure. */
class ToleranceFileTest {
    @TempDir
    private lateinit var folder: Path

    class Mistake(
        val json: String,
        vararg val said: String,
    ) {
        override fun toString() = json.take(60)
    }

    @ParameterizedTest
    @MethodSource("mistakes")
    fun `a mistake is told`(mistake: Mistake) {
        val message = assertThrows<InputError> { Tolerance.read(file(mistake.json)) }.message.orEmpty()
        for (part in listOf("t.json", *mistake.said)) assertTrue(part in message) { "no \"$part\" in: $message" }
        assertEquals(1, message.lines().size, message)
    }

    @Test
    fun `a missing file is told`() {
        val message = assertThrows<InputError> { Tolerance.read(folder.resolve("none.json")) }.message.orEmpty()
        assertTrue("none.json" in message && "does not exist" in message, message)
    }

    @Test
    fun `bounds are read as people write them`() {
        // 51 of 255 is a fifth.
        for (bound in listOf("0.2", "2e-1", "\"51/255\"", "\"20 %\"", "\"20%\"", "\"0.2\"", "\" 51 / 255 \"")) {
            val tolerance = Tolerance.read(file("""{"byte": {"metric": "max", "fail": $bound, $WHY}}"""))
            assertTrue(tolerance.judge(against(151)).messages.isEmpty(), bound)
            assertEquals(1, tolerance.judge(against(152)).messages.size, bound)
        }
    }

    @Test
    fun `a tier is chosen by renderer, processor and machine, the first that fits`() {
        val tiers = ToleranceTiers.read(file(TIERS))
        val avx = listOf("avx", "ssse3")

        fun choose(
            renderer: String,
            cpu: List<String>,
            same: Boolean,
        ) = tiers.choose(renderer, cpu, same)?.name
        assertEquals("exact", choose("llvmpipe (LLVM 15)", avx, true))
        assertEquals("loose", choose("llvmpipe (LLVM 15)", avx, false))
        assertEquals("exact", choose("llvmpipe", listOf("asimd"), true))
        assertEquals(null, choose("llvmpipe", listOf("asimd"), false))
        assertEquals(null, choose("softpipe", avx, true))
        assertEquals(null, choose("an llvmpipe", avx, true))
    }

    @Test
    fun `of several tiers one is named`() {
        assertEquals("loose", Tolerance.read(file(TIERS), "loose").name)
        for (tier in listOf(null, "lose")) {
            val message = assertThrows<InputError> { Tolerance.read(file(TIERS), tier) }.message.orEmpty()
            assertTrue("exact, loose" in message, message)
        }
        assertThrows<InputError> { Tolerance.read(file("""{"byte": {"metric": "max", "fail": 0, $WHY}}"""), "loose") }
    }

    private fun file(json: String): Path = folder.resolve("t.json").also { it.writeText(json) }

    private companion object {
        const val WHY = """"reason": "r", "machine": "m""""
        const val RULE = """"byte": {"metric": "max", "fail": 0, $WHY}"""
        const val TIERS =
            """{"tiers": [{"name": "exact", "renderer": "llvmpipe.*", "sameMachine": true, $RULE},
                {"name": "loose", "renderer": "llvmpipe.*", "cpu": "ssse3", $RULE}]}"""

        @JvmStatic
        fun mistakes(): List<Mistake> = files() + rules() + bounds().map { Mistake(max(""""fail": $it"""), "byte.fail", "2/255") } + tiers()

        private fun files() =
            listOf(
                Mistake("", "not JSON"),
                Mistake("{", "not JSON"),
                Mistake("[]", "an object"),
                Mistake("{}", "\"byte\", \"float\""),
                Mistake("""{"bytes": {}}""", "\"bytes\" is not known"),
                Mistake("""{"byte": 3}""", "byte: must be an object"),
            )

        private fun rules() =
            listOf(
                Mistake("""{"byte": {"fail": 0, $WHY}}""", "byte: \"metric\" is missing"),
                Mistake("""{"byte": {"metric": "mx", "fail": 0, $WHY}}""", "byte.metric", "\"mx\" is no metric", "flip percentile"),
                Mistake("""{"byte": {"metric": "max", "fail": 0, "machine": "m"}}""", "\"reason\" is missing"),
                Mistake("""{"byte": {"metric": "max", "fail": 0, "reason": "r"}}""", "\"machine\" is missing"),
                Mistake("""{"byte": {"metric": "max", "fail": 0, "reason": " ", "machine": "m"}}""", "byte.reason", "empty"),
                Mistake("""{"byte": {"metric": "max", "fail": 0, "reason": 3, "machine": "m"}}""", "byte.reason", "in quotes"),
                Mistake("""{"byte": {"metric": "max", $WHY}}""", "\"warn\", \"fail\" or both"),
                Mistake(max(""""warn": 0.2, "fail": 0.1"""), "reached before"),
                Mistake(max(""""warn": 0.1, "fail": 0.1"""), "reached before"),
                Mistake("""{"byte": {"metric": "psnr", "warn": 30, "fail": 40, $WHY}}""", "reached before"),
                Mistake(max(""""fails": 0, "fail": 0"""), "\"fails\" is not known"),
                Mistake(max(""""fail": 0, "size": 4"""), "\"size\" is not known"),
                Mistake("""{"byte": {"metric": "window", "fail": 0, $WHY}}""", "\"size\" is missing"),
                Mistake("""{"byte": {"metric": "window", "size": 0, "fail": 0, $WHY}}""", "byte.size", "at least 1"),
                Mistake("""{"byte": {"metric": "window", "size": 1.5, "fail": 0, $WHY}}""", "byte.size"),
                Mistake("""{"byte": {"metric": "flip percentile", "percent": 100, "fail": 0, $WHY}}""", "byte.percent", "below 100"),
                Mistake("""{"byte": {"all": []}}""", "byte.all", "empty list"),
                Mistake("""{"byte": {"all": {}}}""", "byte.all", "must be a list"),
                Mistake("""{"byte": {"all": [], "any": []}}""", "\"any\" is not known"),
                Mistake("""{"float": {"any": [{"all": [{"metric": "max", "fail": "x", $WHY}]}]}}""", "float.any[0].all[0].fail", "\"x\""),
                Mistake(nested(21), "nested deeper"),
                Mistake(nested(50_000), "too nested"),
            )

        private fun nested(levels: Int) = """{"byte": ${"""{"all": [""".repeat(levels)}1${"]}".repeat(levels)}}"""

        private fun bounds() =
            listOf("-1", "\"-1/255\"", "\"1/0\"", "\"1/2/3\"", "\"NaN\"", "1e999", "\"0x10\"", "\"2 apples\"", "\"%\"", "true", "[]")

        private fun tiers() =
            listOf(
                Mistake("""{"tiers": []}""", "tiers: is an empty list"),
                Mistake("""{"tiers": [{"renderer": ".*", $RULE}]}""", "tiers[0]: \"name\" is missing"),
                Mistake("""{"tiers": [{"name": "a", $RULE}]}""", "\"renderer\" is missing"),
                Mistake("""{"tiers": [{"name": "a", "renderer": "(", $RULE}]}""", "tiers[0].renderer", "regular expression"),
                Mistake("""{"tiers": [{"name": "a", "renderer": "x", "sameMachine": "yes", $RULE}]}""", "true or false"),
                Mistake("""{"tiers": [{"name": "a", "renderer": "x"}]}""", "tiers[0]: bounds nothing"),
                Mistake("""{"tiers": [{"name": "a", "renderer": "x", $RULE}, {"name": "a", "renderer": "y", $RULE}]}""", "two tiers \"a\""),
            )

        private fun max(bounds: String) = """{"byte": {"metric": "max", $bounds, $WHY}}"""
    }
}
