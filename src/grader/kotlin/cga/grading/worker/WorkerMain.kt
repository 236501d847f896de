package cga.grading.worker

import java.lang.reflect.InvocationTargetException
import java.net.URL
import java.nio.file.Path
import kotlin.system.exitProcess

/** Runs a submission: `WorkerMain <class with main> <capture file> <folder or jar with its classes>…`. */
public object WorkerMain {
    /** Exit code 0 when the script was played to its end or the submission failed by itself, 2 when it could not be started, 3 without OpenGL. */
    @JvmStatic
    public fun main(args: Array<String>) {
        if (args.size < 2) {
            System.err.println("usage: WorkerMain <class with main> <capture file> <classes>…")
            exitProcess(USAGE)
        }
        run(args[0], Path.of(args[1]), args.drop(2).map { Path.of(it) })
        // Without waiting for threads of the submission, and without its shutdown hooks.
        Runtime.getRuntime().halt(0)
    }

    /** Runs the class [name] of [classes] to its end, and has its capture written to [capture]. */
    public fun run(
        name: String,
        capture: Path,
        classes: List<Path>,
    ) {
        Session.begin(capture)
        try {
            start(name, classes.map { it.toUri().toURL() })
        } catch (e: InvocationTargetException) {
            generateSequence(e.targetException) { it.cause }.take(MAX_CAUSES).firstOrNull { it is NoWindow }?.let { giveUp(it, NO_OPENGL) }
            Session.fail(e.targetException)
            e.targetException.printStackTrace()
        } catch (e: ReflectiveOperationException) {
            giveUp(e, USAGE)
        } catch (e: LinkageError) {
            Session.fail(e)
            e.printStackTrace()
        }
        Session.finish()
    }

    private fun start(
        name: String,
        classes: List<URL>,
    ) {
        val loader = SubmissionLoader(classes)
        Thread.currentThread().contextClassLoader = loader
        val type = Class.forName(name, true, loader)
        val method =
            type.methods.firstOrNull { it.name == "main" && it.parameterTypes.contentEquals(arrayOf(Array<String>::class.java)) }
                ?: type.methods.firstOrNull { it.name == "main" && it.parameterCount == 0 }
                ?: throw NoSuchMethodException("$name.main")
        if (method.parameterCount == 0) method.invoke(null) else method.invoke(null, emptyArray<String>())
    }

    private fun giveUp(
        reason: Throwable,
        code: Int,
    ): Nothing {
        System.err.println("the submission cannot be started: $reason")
        Session.abandon()
        exitProcess(code)
    }

    private const val MAX_CAUSES = 8
    private const val NO_OPENGL = 3
    private const val USAGE = 2
}
