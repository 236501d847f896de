package cga.grading.sheet4.scene

import cga.grading.capture.CapturedEvent
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.ProgramFacts
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

internal fun Rig.verdict(
    profile: SceneProfile = SceneProfile.SHEET,
    events: List<CapturedEvent> = emptyList(),
    uniforms: Set<String> = emptySet(),
    program: ProgramFacts = ProgramFacts(),
): SceneVerdict = SceneJudge.judge(play(), events, profile, uniforms, program)

internal fun SceneVerdict.text(): String =
    buildList {
        checks.mapTo(this) { "${it.check} ${it.error} ${it.text}" }
        mistakes.mapTo(this) { "! ${it.mistake} ${it.fit} ${it.difference} ${it.where} ${it.alternatives}" }
        notes.mapTo(this) { "$it" }
    }.joinToString("\n")

/** Asserts that every check is measured, none is off by more than [tolerance], and no mistake is named. */
internal fun SceneVerdict.assertRight(tolerance: Double = 1e-3) {
    assertEquals(SceneJudge.CHECKS, checks.map { it.check }.toSet(), text())
    for (check in checks) {
        val error = check.error
        assertTrue(error != null && error <= tolerance) { "${check.check} is $error, more than $tolerance: ${check.text}\n\n${text()}" }
    }
    assertEquals(emptyList<Mistake>(), mistakes.map { it.mistake }, text())
}

/** Asserts that [mistake] and nothing else is named, that it costs [costs], and that everything else is as good as in a right scene. */
internal fun SceneVerdict.assertMistake(
    mistake: Mistake,
    vararg costs: Check = arrayOf(mistake.check),
    least: Double = 0.05,
) {
    assertEquals(listOf(mistake), mistakes.map { it.mistake }.distinct(), text())
    assertCosts(*costs, least = least)
}

/** Asserts that [costs] are off by at least [least] and all other checks are right. */
internal fun SceneVerdict.assertCosts(
    vararg costs: Check,
    least: Double = 0.05,
) {
    for (check in checks) {
        val error = if (check.found) check.error else 1.0
        if (error == null) throw AssertionError("${check.check} was not measured: ${check.text}\n\n${text()}")
        if (check.check in costs) {
            assertTrue(error >= least) { "${check.check} is only $error: ${check.text}\n\n${text()}" }
        } else {
            assertTrue(error <= 3e-3) { "${check.check} is $error and should not suffer: ${check.text}\n\n${text()}" }
        }
    }
    assertEquals(SceneJudge.CHECKS, checks.map { it.check }.toSet(), text())
}
