package cga.cli

import cga.framework.InputError
import cga.framework.Natives
import cga.framework.Phases
import cga.framework.context.OffscreenContext
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.NoOpCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import org.lwjgl.system.Configuration
import java.io.FileDescriptor
import java.io.FileOutputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.charset.Charset
import java.nio.file.Path
import kotlin.system.exitProcess

/** What went wrong on the user's side: bad usage, bad input. */
private const val EXIT_USER_ERROR = 2

/** What Java puts in the place of bytes that are no letters in its encoding. */
private const val UNREADABLE = '\uFFFD'

/** The command line: `cga COMMAND …`. */
public fun main(args: Array<String>) {
    // Pictures are encoded by the JDK; nothing of its desktop may start beside GLFW.
    System.setProperty("java.awt.headless", "true")
    writeUtf8WithoutLocale()
    // Where a library is missing our own message says so, and what to install; LWJGL's is for programmers.
    Configuration.DEBUG_STREAM.set(PrintStream(OutputStream.nullOutputStream()))
    System.getProperty("cga.natives")?.let { Natives.keepIn(Path.of(it)) }
    // LWJGL would look for jemalloc, which is not there.
    Configuration.MEMORY_ALLOCATOR.set("system")
    val status =
        Phases.span("main") {
            // The driver loads while the command reads its options.
            if (args.firstOrNull() == "render") OffscreenContext.prepare()
            execute(cga(args.toList()), args.toList())
        }
    Phases.save()
    exitProcess(status)
}

/** Where no locale is set Java writes ASCII, and `?` for all else. UTF-8 is what such a terminal shows, as Python assumes too. */
private fun writeUtf8WithoutLocale() {
    if (Charset.forName(System.getProperty("native.encoding")) != Charsets.US_ASCII) return
    System.setOut(PrintStream(FileOutputStream(FileDescriptor.out), true, Charsets.UTF_8))
    System.setErr(PrintStream(FileOutputStream(FileDescriptor.err), true, Charsets.UTF_8))
}

/** Each command's class, in the order of the help. It lies in the part that does its work, which need not be there. */
private val COMMANDS: Map<String, String> =
    mapOf(
        "run" to "cga.cli.window.RunCommand",
        "render" to "cga.cli.RenderCommand",
        "replay" to "cga.cli.window.ReplayCommand",
        "diff" to "cga.cli.DiffCommand",
        "golden" to "cga.cli.lab.GoldenCommand",
        "doctor" to "cga.cli.window.DoctorCommand",
        "bench" to "cga.cli.lab.BenchCommand",
        "accuracy" to "cga.cli.lab.AccuracyCommand",
        "soak" to "cga.cli.lab.SoakCommand",
        "starter" to "cga.cli.grader.StarterCommand",
        "grade" to "cga.cli.grader.GradeCommand",
        "gradescope" to "cga.cli.grader.GradescopeCommand",
    )

/** The command line with the command that is asked for; with all that are here only where there is none, for help. Making one takes time. */
private fun cga(args: List<String>): CliktCommand {
    val asked = args.firstOrNull()?.let(::command)
    return NoOpCliktCommand("cga").subcommands(if (asked != null) listOf(asked) else COMMANDS.keys.mapNotNull(::command))
}

/** The command called [name]; null where there is none, or its part is not here. */
public fun command(name: String): CliktCommand? =
    try {
        COMMANDS[name]?.let { Class.forName(it).getConstructor().newInstance() as CliktCommand }
    } catch (_: ClassNotFoundException) {
        null
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
        if (e.statusCode != 0 && args.any { UNREADABLE in it }) {
            System.err.println("cga: Java reads names in ${System.getProperty("native.encoding")} here: set LC_ALL=C.UTF-8, as ./cga does.")
        }
        // Help that was asked for is no error; help instead of a command is.
        if (e.statusCode == 0 && args.isNotEmpty()) 0 else EXIT_USER_ERROR
    } catch (e: InputError) {
        System.err.println("cga: ${e.message}")
        EXIT_USER_ERROR
    } catch (_: OutOfMemoryError) {
        System.err.println("cga: not enough memory for this: give a smaller size, or more memory with JAVA_TOOL_OPTIONS=-Xmx4g.")
        EXIT_USER_ERROR
    }
