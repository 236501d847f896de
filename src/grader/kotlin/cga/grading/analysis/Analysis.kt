package cga.grading.analysis

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.findings.Findings
import cga.grading.findings.Found
import cga.grading.findings.Message
import cga.grading.replay.Replay
import cga.grading.sheet4.scene.SceneJudge
import cga.grading.sheet4.scene.SceneProfile
import cga.grading.study.ShaderStudy
import cga.grading.study.UnlitDraws
import cga.grading.substitute.Substitutes
import java.nio.file.Path

/**
 * Measures a capture: draws its frames again, studies what its shaders compute, judges what its scene does, and takes pictures that show
 * it. Needs a current context.
 *
 * @param folder where the pictures go; null for none.
 */
internal class Analysis(
    private val given: Capture,
    private val edition: String,
    private val folder: Path?,
) {
    /** Throws [Threw], [EndedEarly], [NothingDrawn], [NotReproducible] and [cga.grading.replay.ReplayError]. */
    fun findings(): Findings {
        checkRun()
        val unlit = UnlitDraws.of(given)
        return findings(unlit.capture, unlit.programs)
    }

    private fun findings(capture: Capture, unlit: Set<Int>): Findings =
        Replay(capture).use { replay ->
            Reproduction.check(capture, replay)
            val substitutes = Substitutes.of(capture)
            ShaderStudy.of(substitutes.capture, unlit).use { study ->
                val observed = substitutes.capture.frames.mapNotNull(study::observe)
                val profile = if (edition == "2022") SceneProfile.LATER else SceneProfile.SHEET
                val facts = CaptureFacts(capture)
                val scene = SceneJudge.judge(observed, capture.events, profile, facts.uniforms, facts.program(study, substitutes))
                val verdict = Verdict.of(ShadingVerdict(study.checks, study.mistakes), scene)
                val pictures =
                    folder?.let {
                        val expected = ExpectedFrame(capture, study.materials, verdict)
                        ScenePictures(capture, replay, study.materials, expected, observed, it).take()
                    } ?: emptyList()
                Findings(
                    verdict.checks,
                    located(verdict.mistakes),
                    study.plots,
                    pictures,
                    study.notes.map(Message::plain) + scene.notes + eventNotes().map(Message::plain),
                )
            }
        }

    /** Only where something is wrong is it worth reading the shaders once more. */
    private fun located(mistakes: List<Found>): List<Found> =
        if (mistakes.isEmpty()) mistakes else ShaderLines(given).let { lines -> mistakes.map(lines::located) }

    private fun checkRun() {
        val isEmpty = given.frames.none { frame -> frame.steps.any { it is CapturedDraw } }
        val thrown = given.events.firstOrNull { it.kind == EventKind.EXCEPTION }
        if (isEmpty && thrown != null) throw Threw(thrown.text)
        if (thrown == null && given.frames.size < Moment.entries.size) {
            throw EndedEarly(
                "The program ended by itself after ${given.frames.size} of ${Moment.entries.size} pictures, without an exception.",
            )
        }
        if (isEmpty) throw NothingDrawn(whyNothing())
    }

    private fun whyNothing(): String {
        val problem = given.events.firstOrNull { it.kind in FATAL } ?: return "No draw call was made in ${given.frames.size} frames."
        return "Nothing was drawn. ${problem.text}"
    }

    /** What went wrong beside the drawing, each thing once. */
    private fun eventNotes(): List<String> =
        given.events
            .filter { it.kind !in QUIET }
            .groupBy { it.kind to it.text }
            .map { (what, all) ->
                "${what.first.name.lowercase().replace('_', ' ')}: ${what.second}" +
                    if (all.size > 1) " (${all.size} times)" else ""
            }.take(MOST_NOTES)

    private companion object {
        const val MOST_NOTES = 20
        val FATAL = setOf(EventKind.EXCEPTION, EventKind.SHADER_FAILED, EventKind.LINK_FAILED, EventKind.NOT_CAPTURED)

        /** The scene judge has its own words for these. */
        val QUIET =
            setOf(
                EventKind.UNIFORM_ABSENT,
                EventKind.UNIFORM_WITHOUT_PROGRAM,
                EventKind.UNIFORM_OVERWRITTEN,
                EventKind.TEXTURE_FILE,
                EventKind.GL_ERROR,
                EventKind.SHADER_DIALECT,
                EventKind.ANISOTROPY,
            )
    }
}
