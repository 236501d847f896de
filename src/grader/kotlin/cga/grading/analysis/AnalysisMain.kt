package cga.grading.analysis

import cga.framework.InputError
import cga.framework.context.OffscreenContext
import cga.grading.capture.BadCapture
import cga.grading.capture.CaptureFile
import cga.grading.findings.FindingsFile
import cga.grading.findings.LikenessFile
import cga.grading.likeness.CaptureShape
import cga.grading.replay.ReplayError
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * The process that measures a capture: `AnalysisMain <capture file> <folder for the findings> <edition>`.
 *
 * Exit codes: 0 done, 2 the grader's own fault, 3 the capture is damaged or faked, 4 its frames cannot be drawn again, 5 nothing was drawn,
 * 6 it threw before anything was drawn, 7 it ended by itself amid the script, 8 it needs more memory than there is. What is said to standard
 * error is the whole message.
 */
public object AnalysisMain {
    @JvmStatic
    public fun main(args: Array<String>) {
        exitProcess(run(Path.of(args[0]), Path.of(args[1]), args[2]))
    }

    private fun run(file: Path, folder: Path, edition: String): Int =
        try {
            val capture = CaptureFile.read(file)
            LikenessFile.write(CaptureShape.keys(capture), folder)
            OffscreenContext.open().use { FindingsFile.write(Analysis(capture, edition, folder).findings(), folder) }
            0
        } catch (e: BadCapture) {
            say(e, CAPTURE_UNREADABLE)
        } catch (e: NotReproducible) {
            say(e, NOT_REPRODUCIBLE)
        } catch (e: ReplayError) {
            say(e, NOT_REPRODUCIBLE)
        } catch (e: NothingDrawn) {
            say(e, NOTHING_DRAWN)
        } catch (e: Threw) {
            say(e, THREW)
        } catch (e: EndedEarly) {
            say(e, ENDED_EARLY)
        } catch (e: InputError) {
            say(e, INTERNAL)
        } catch (e: OutOfMemoryError) {
            say(e, OUT_OF_MEMORY)
        }

    private fun say(e: Throwable, code: Int): Int {
        System.err.println(e.message)
        return code
    }

    private const val INTERNAL = 2
    private const val CAPTURE_UNREADABLE = 3
    private const val NOT_REPRODUCIBLE = 4
    private const val NOTHING_DRAWN = 5
    private const val THREW = 6
    private const val ENDED_EARLY = 7
    private const val OUT_OF_MEMORY = 8
}

/** The frames, drawn again, are not those that the worker said it saw. */
internal class NotReproducible(message: String) : Exception(message)

/** The submission drew no triangle. */
internal class NothingDrawn(message: String) : Exception(message)

/** The submission threw before it drew a triangle; the message is the exception with the submission's own lines. */
internal class Threw(message: String) : Exception(message)

/** The submission ended by itself, without an exception, before the script did. */
internal class EndedEarly(message: String) : Exception(message)
