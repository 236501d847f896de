package cga.imaging.golden

import cga.framework.InputError
import cga.imaging.Comparison
import cga.imaging.Severity
import cga.imaging.tolerance.ToleranceTiers

/** Judges pictures by the approved images in [store], with the tolerance of [tiers] that is for their renderer. */
public class GoldenJudge(
    private val store: GoldenStore,
    private val tiers: ToleranceTiers,
) {
    /** What to say of [rendered] as the picture of [case]. Of several approved images the one that it suits best counts. */
    public fun judge(
        case: String,
        rendered: Rendered,
    ): Outcome =
        try {
            val approved = store.approved(case)
            if (approved.isEmpty()) {
                failed("there is no golden: look at the picture, then ${GoldenStore.acceptCommand(case)}")
            } else {
                // Lazily: when one is met exactly, no other needs to be compared.
                approved.asSequence().map { judge(case, rendered, it) }.best()
            }
        } catch (e: InputError) {
            failed(e.message.orEmpty())
        }

    /** A failure for every golden in the store whose case is none of [known], by the name of its case. */
    public fun strays(known: Set<String>): Map<String, Outcome> =
        (store.cases() - known).associateWith {
            failed("there is no case of this name: delete the files $it.*, or add the case to the list")
        }

    private fun judge(
        case: String,
        rendered: Rendered,
        approved: Approved,
    ): Outcome {
        val changes = rendered.origin.changesSince(approved.origin)
        val changed = "inputs changed since approval (${changes.joinToString()})"
        val again = "look at it, then ${GoldenStore.acceptCommand(case)}"
        val comparison =
            try {
                Comparison(approved.picture, rendered.picture)
            } catch (e: InputError) {
                return failed(listOfNotNull("$changed: $again".takeIf { changes.isNotEmpty() }, e.message))
            }
        if (comparison.isIdentical) {
            val note = listOfNotNull("$changed, but no pixel did: ${GoldenStore.acceptCommand(case)}".takeIf { changes.isNotEmpty() })
            return Outcome(if (changes.isEmpty()) Severity.PASS else Severity.WARN, note, comparison)
        }
        val machine = rendered.origin.machine
        val tolerance =
            tiers.choose(machine.renderer, machine.cpu, machine == approved.origin.machine)
                ?: return skipped(machine, approved.origin.machine.renderer, comparison)
        val verdict = tolerance.judge(comparison)
        val messages = verdict.messages.map { "$it [tier ${tolerance.name}]" }
        return when {
            changes.isEmpty() -> Outcome(verdict.severity, messages, comparison)
            verdict.severity == Severity.FAIL -> Outcome(Severity.FAIL, listOf("$changed: $again") + messages, comparison)
            else -> Outcome(Severity.WARN, listOf("$changed, and the picture within tolerance: $again") + messages, comparison)
        }
    }

    private fun skipped(
        machine: Machine,
        wanted: String,
        comparison: Comparison,
    ): Outcome {
        val here = "${machine.renderer} on a processor with ${machine.cpu.ifEmpty { listOf("no known features") }.joinToString(" ")}"
        val message = "skipped: needs ${wanted.substringBefore(' ')}; the pictures differ, and no tier of the tolerance is for $here"
        return Outcome(Severity.WARN, listOf(message), comparison, isSkipped = true)
    }

    private fun failed(messages: List<String>) = Outcome(Severity.FAIL, messages)

    private fun failed(message: String) = failed(listOf(message))

    /** The least severe, the first of equals; a skip is no verdict, so any other comes before it. */
    private fun Sequence<Outcome>.best(): Outcome {
        val outcomes = mutableListOf<Outcome>()
        for (outcome in this) {
            if (outcome.severity == Severity.PASS) return outcome
            outcomes += outcome
        }
        return outcomes.minWith(compareBy({ it.isSkipped }, { it.severity }))
    }
}
