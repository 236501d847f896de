package cga.cli

import cga.framework.InputError
import cga.framework.Phases
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.NoOpCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import org.lwjgl.system.Configuration
import java.io.OutputStream
import java.io.PrintStream
import kotlin.system.exitProcess

/** What went wrong on the user's side: bad usage, bad input. */
private const val EXIT_USER_ERROR = 2

/** The command line: `cga COMMAND …`. */
public fun main(args: Array<String>) {
    // Pictures are encoded by the JDK; nothing of its desktop may start beside GLFW.
    System.setProperty("java.awt.headless", "true")
    // Where a library is missing our own message says so, and what to install; LWJGL's is for programmers.
    Configuration.DEBUG_STREAM.set(PrintStream(OutputStream.nullOutputStream()))
    val status = Phases.span("main") { execute(cga(args.toList()), args.toList()) }
    Phases.save()
    exitProcess(status)
}

/** In the order of the help. */
internal val COMMANDS: Map<String, () -> CliktCommand> =
    mapOf(
        "run" to ::RunCommand,
        "render" to ::RenderCommand,
        "replay" to ::ReplayCommand,
        "diff" to ::DiffCommand,
        "golden" to ::GoldenCommand,
        "doctor" to ::DoctorCommand,
        "bench" to ::BenchCommand,
        "accuracy" to ::AccuracyCommand,
        "soak" to ::SoakCommand,
        "starter" to ::StarterCommand,
        "grade" to { GradeCommand(::gradeOne) },
        "gradescope" to ::GradescopeCommand,
    )

/** The command line with the command that is asked for; with all of them only where there is none, for help. Making one takes time. */
private fun cga(args: List<String>): CliktCommand {
    val asked = COMMANDS[args.firstOrNull()]
    return NoOpCliktCommand("cga").subcommands((if (asked != null) listOf(asked) else COMMANDS.values).map { it() })
}

private fun execute(
    command: CliktCommand,
    args: List<String>,
): Int =
    try {
        command.parse(args)
        0
    } catch (e: ProgramResult) {
        // A command's own answer, not an error in how it was asked.
        e.statusCode
    } catch (e: CliktError) {
        command.echoFormattedHelp(e)
        // Help that was asked for is no error; help instead of a command is.
        if (e.statusCode == 0 && args.isNotEmpty()) 0 else EXIT_USER_ERROR
    } catch (e: InputError) {
        System.err.println("cga: ${e.message}")
        EXIT_USER_ERROR
    } catch (_: OutOfMemoryError) {
        System.err.println("cga: not enough memory for this: give a smaller size, or more memory with JAVA_TOOL_OPTIONS=-Xmx4g.")
        EXIT_USER_ERROR
    }
