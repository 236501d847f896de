package cga.grading.pipeline

import cga.grading.sandbox.End
import cga.grading.sandbox.Outcome
import java.nio.file.Path
import kotlin.io.path.createDirectories

/** What may crash through no fault of a submission's: once in some 400 measurements the driver does, with shaders it drew sixty times. */
internal object SecondTry {
    /** Has [attempt] run in a folder of its own in [scratch], after a native crash in another: how the last one ended, and its folder. */
    fun after(scratch: Path, attempt: (Path) -> Outcome): Pair<Outcome, Path> {
        val first = scratch.resolve("first").createDirectories()
        val outcome = attempt(first)
        if (outcome.end !is End.Signalled) return outcome to first
        val second = scratch.resolve("second").createDirectories()
        return attempt(second) to second
    }
}
