package cga.grading.submission

import cga.framework.InputError
import cga.grading.prepared.Edition
import java.io.IOException
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * The process that reads what was handed in: `PrepareMain <folder or archive> <folder for the tree> <edition, or nothing>`.
 *
 * Exit codes: 0 done, 2 the grader's own fault, 3 it is no submission, 4 it cannot be read, 5 this user may not read it. What is said to
 * standard error is the whole message.
 */
internal object PrepareMain {
    @JvmStatic
    fun main(args: Array<String>) {
        exitProcess(run(Path.of(args[0]), Path.of(args[1]), args[2].ifEmpty { null }))
    }

    private fun run(given: Path, folder: Path, edition: String?): Int =
        try {
            Preparation.prepare(given, folder, edition?.let(Edition::named))
            0
        } catch (e: BadArchive) {
            say(e.message, REFUSED)
        } catch (e: NotASubmission) {
            say(e.message, NOT_RECOGNIZED)
        } catch (e: InputError) {
            say(e.message, REFUSED)
        } catch (e: Unreadable) {
            say(e.message, UNREADABLE)
        } catch (e: NoRoom) {
            say("the disk is full: ${e.message}", INTERNAL)
        } catch (e: IOException) {
            say("$e", INTERNAL)
        } catch (_: StackOverflowError) {
            say("It is nested too deeply to be read.", REFUSED)
        } catch (_: OutOfMemoryError) {
            say("It takes more memory to be read than there is.", REFUSED)
        }

    private fun say(message: String?, code: Int): Int {
        System.err.println(message)
        return code
    }

    private const val INTERNAL = 2
    private const val NOT_RECOGNIZED = 3
    private const val REFUSED = 4
    private const val UNREADABLE = 5
}
