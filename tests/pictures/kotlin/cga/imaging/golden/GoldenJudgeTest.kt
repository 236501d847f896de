package cga.imaging.golden

import cga.imaging.Severity
import cga.imaging.Severity.FAIL
import cga.imaging.Severity.PASS
import cga.imaging.Severity.WARN
import cga.imaging.tolerance.ToleranceTiers
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.deleteExisting
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Every way in which a case can end, with a small store. */
class GoldenJudgeTest {
    @TempDir
    private lateinit var folder: Path
    private lateinit var store: GoldenStore
    private lateinit var judge: GoldenJudge

    @BeforeEach
    fun `a store with one golden, a grey of 100`() {
        folder.resolve("tolerance.json").writeText(TIERS)
        store = GoldenStore(folder)
        judge = GoldenJudge(store, ToleranceTiers.read(folder.resolve("tolerance.json")))
        store.accept("case", drawn(100), "looks right")
    }

    @Test
    fun `the same picture passes and says nothing`() {
        assertSays(PASS, judge.judge("case", drawn(100)))
    }

    @Test
    fun `on the same machine one step is too much`() {
        assertSays(FAIL, judge.judge("case", drawn(101)), "max 1/255", "allowed 0,", "tier exact")
    }

    @Test
    fun `on another machine of the kind what its tier allows passes, and no more`() {
        val other = LLVMPIPE.copy(driver = "Mesa 25.0.7")
        assertSays(PASS, judge.judge("case", drawn(102, other)))
        assertSays(WARN, judge.judge("case", drawn(103, other)), "3/255", "tier llvmpipe")
        assertSays(FAIL, judge.judge("case", drawn(105, other)), "5/255", "tier llvmpipe")
        for (machine in listOf(
            LLVMPIPE.copy(cpu = listOf("ssse3")),
            LLVMPIPE.copy(settings = mapOf("GALLIVM_PERF" to "no_aos_sampling")),
        )) {
            assertSays(PASS, judge.judge("case", drawn(102, machine)))
        }
    }

    @Test
    fun `changed inputs are named, and not called a difference of pixels`() {
        val changed = drawn(101, inputs = mapOf("shaders/scene.frag" to "ff", "scene lights" to "2b"), made = mapOf("t" to "5.4"))
        val outcome = judge.judge("case", changed)
        assertSays(FAIL, outcome, "inputs changed since approval (shaders/scene.frag, t 5.3 → 5.4)", "./cga golden accept case")
        assertFalse("scene lights" in outcome.messages.first())
        assertTrue("max 1/255" in outcome.messages[1])
    }

    @Test
    fun `inputs that come or go have changed too`() {
        val outcome = judge.judge("case", drawn(101, inputs = mapOf("shaders/scene.frag" to "1a", "assets/new" to "3c")))
        assertSays(FAIL, outcome, "(assets/new, scene lights)")
    }

    @Test
    fun `changed inputs without an effect are a warning`() {
        val outcome = judge.judge("case", drawn(100, inputs = mapOf("shaders/scene.frag" to "ff", "scene lights" to "2b")))
        assertSays(WARN, outcome, "inputs changed since approval (shaders/scene.frag), but no pixel did")
    }

    @Test
    fun `changed inputs with an effect within tolerance are a warning`() {
        val outcome = judge.judge("case", drawn(102, LLVMPIPE.copy(cpu = listOf("ssse3")), made = mapOf("t" to "6")))
        assertSays(WARN, outcome, "inputs changed since approval (t 5.3 → 6)", "within tolerance")
    }

    @Test
    fun `a missing golden fails with the command that makes one`() {
        assertSays(FAIL, judge.judge("other", drawn(100)), "no golden", "./cga golden accept other --reason")
    }

    @Test
    fun `a golden without a case fails`() {
        val strays = judge.strays(setOf("other"))
        assertEquals(setOf("case"), strays.keys)
        assertSays(FAIL, strays.getValue("case"), "delete the files case.*")
        assertEquals(emptySet<String>(), judge.strays(setOf("case", "other")).keys)
    }

    @Test
    fun `another size fails`() {
        val outcome = judge.judge("case", drawn(0, picture = grey(100, width = 9)))
        assertEquals(FAIL, outcome.severity)
        assertTrue("9" in outcome.messages.single() && "8" in outcome.messages.single(), "${outcome.messages}")
        assertNull(outcome.comparison)
    }

    @Test
    fun `on a renderer without a tier it is skipped, unless the picture is the same`() {
        val softpipe = Machine("softpipe", "Mesa 22.3.6", listOf("avx", "ssse3"), emptyMap())
        val old = LLVMPIPE.copy(cpu = listOf("asimd"))
        for (machine in listOf(softpipe, old)) {
            val outcome = judge.judge("case", drawn(101, machine))
            assertTrue(outcome.isSkipped)
            assertSays(WARN, outcome, "skipped: needs llvmpipe", machine.renderer, machine.cpu.last())
            assertSays(PASS, judge.judge("case", drawn(100, machine)))
        }
    }

    @Test
    fun `of several approved images the best counts`() {
        store.accept("case", drawn(150), "another driver's", also = true)
        assertSays(PASS, judge.judge("case", drawn(100)))
        assertSays(PASS, judge.judge("case", drawn(150)))
        val other = LLVMPIPE.copy(driver = "Mesa 25.0.7")
        assertSays(WARN, judge.judge("case", drawn(147, other)), "expected 150  150  150, actual 147  147  147")
        assertSays(FAIL, judge.judge("case", drawn(125, other)))
    }

    @Test
    fun `broken files fail in one line`() {
        val sidecar = folder.resolve("case.json")
        val text = sidecar.readText()
        for ((broken, said) in listOf(
            "" to "not JSON",
            "{}" to "\"approved\" is missing",
            text.replace("looks right", "") to "approved.reason",
            text.replace(Regex(""""date": ".*""""), """"date": "soon"""") to "2026-01-31",
            text.replace("\"made\"", "\"mode\"") to "\"mode\" is not known",
        )) {
            sidecar.writeText(broken)
            assertSays(FAIL, judge.judge("case", drawn(100)), "case.json", said)
        }
        folder.resolve("case.png").writeText("no picture")
        assertSays(FAIL, judge.judge("case", drawn(100)), "case.png")
    }

    @Test
    fun `half of a pair fails, and says how to cure it`() {
        folder.resolve("case.json").deleteExisting()
        assertSays(FAIL, judge.judge("case", drawn(100)), "case.png has no sidecar", "./cga golden accept case")
        store.accept("case", drawn(100), "again")
        folder.resolve("case.png").deleteExisting()
        assertSays(FAIL, judge.judge("case", drawn(100)), "case.json has no image", "./cga golden accept case")
    }

    @Test
    fun `an image exchanged under its sidecar fails, even for one that looks as it should`() {
        store.accept("twin", drawn(101), "the other grey")
        folder.resolve("twin.png").toFile().copyTo(folder.resolve("case.png").toFile(), overwrite = true)
        assertSays(FAIL, judge.judge("case", drawn(101)), "case.png is not the image that its sidecar describes")
    }

    private fun assertSays(
        severity: Severity,
        outcome: Outcome,
        vararg parts: String,
    ) {
        assertEquals(severity, outcome.severity, "${outcome.messages}")
        if (severity == PASS) assertEquals(emptyList<String>(), outcome.messages)
        for (part in parts) assertTrue(outcome.messages.any { part in it }) { "no \"$part\" in ${outcome.messages}" }
        assertTrue(outcome.messages.none { '\n' in it }, "${outcome.messages}")
    }

    private companion object {
        const val WHY = """"reason": "r", "machine": "m""""
        const val TIERS =
            """{"tiers": [
                {"name": "exact", "renderer": "llvmpipe.*", "sameMachine": true, "byte": {"metric": "max", "fail": 0, $WHY}},
                {"name": "llvmpipe", "renderer": "llvmpipe.*", "cpu": "ssse3",
                    "byte": {"metric": "max", "warn": "2/255", "fail": "4/255", $WHY}}]}"""
    }
}
