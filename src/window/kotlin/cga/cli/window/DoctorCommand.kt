package cga.cli.window

import cga.cli.contextOption
import cga.cli.requireUsage
import cga.cli.stepOption
import cga.exercise.game.ScriptedScene.Companion.PRETTY_TIME
import cga.framework.context.ContextKind
import cga.framework.context.ContextUnavailable
import cga.framework.context.OffscreenContext
import cga.inspect.doctor.SceneDoctor
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.double
import com.github.ajalt.mordant.rendering.Whitespace
import com.github.ajalt.mordant.table.ColumnWidth
import com.github.ajalt.mordant.table.table
import org.lwjgl.Version
import org.lwjgl.opengl.GL33C.*

/** `cga doctor`: what this machine offers. */
internal class DoctorCommand : CliktCommand("doctor") {
    override fun help(
        context: Context,
    ): String = "List the ways to OpenGL on this machine, or why one is not available; with --scene, why the picture is dark."

    private class Finding(
        val kind: ContextKind,
        val works: Boolean,
        val text: String,
    )

    private val scene by option("--scene", help = "Look at the scene instead: the likely causes of a black or unlit picture").flag()
    private val step by stepOption()
    private val time by option("--t", metavar = "SECONDS", help = "Time of the scene. Default: $PRETTY_TIME").double().default(PRETTY_TIME)
    private val context by contextOption()

    override fun run() {
        if (scene) examineScene() else examineContexts()
    }

    /** Ends with 1 where the picture is dark. */
    private fun examineScene() {
        requireUsage(time.isFinite() && time >= 0) { "--t $time: the time must be finite and not negative" }
        val report = SceneDoctor.examine(step, time, context)
        val state = if (report.isBlack) {
            "black"
        } else if (report.isUnlit) {
            "not lit: its lights make no difference"
        } else {
            "lit"
        }
        echo("The picture of step ${step.sheet} is $state.")
        report.findings.forEachIndexed { i, (found, cure) -> echo("${i + 1}. $found\n   $cure") }
        if (report.findings.isEmpty()) echo("None of the usual mistakes was found.")
        if (report.isBlack || report.isUnlit) throw ProgramResult(1)
    }

    private fun examineContexts() {
        val (java, system, processor) = listOf("java.version", "os.name", "os.arch").map(System::getProperty)
        echo("Java $java, $system $processor, LWJGL ${Version.getVersion()}")
        val findings = ContextKind.entries.map(::examine)
        terminal.println(
            table {
                whitespace = Whitespace.PRE_WRAP
                // The heading's width and the padding; only the text may wrap.
                column(0) { width = ColumnWidth.Fixed(9) }
                column(1) { width = ColumnWidth.Fixed(7) }
                header { row("context", "works", "OpenGL and renderer, or the reason") }
                body { findings.forEach { row(it.kind.name.lowercase(), if (it.works) "yes" else "no", it.text) } }
            },
        )
        if (findings.none { it.works }) throw ProgramResult(2)
    }

    private fun examine(kind: ContextKind): Finding =
        try {
            OffscreenContext.open(kind).use {
                Finding(
                    kind,
                    true,
                    "OpenGL ${glGetString(GL_VERSION)}, GLSL ${glGetString(GL_SHADING_LANGUAGE_VERSION)}\n${glGetString(GL_RENDERER)}",
                )
            }
        } catch (e: ContextUnavailable) {
            Finding(kind, false, e.message.orEmpty().substringAfter(": "))
        }
}
