package cga.cli

import cga.framework.context.ContextKind
import cga.framework.context.ContextUnavailable
import cga.framework.context.OffscreenContext
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.mordant.rendering.Whitespace
import com.github.ajalt.mordant.table.ColumnWidth
import com.github.ajalt.mordant.table.table
import org.lwjgl.Version
import org.lwjgl.opengl.GL33C.*

/** `cga doctor`: what this machine offers. */
internal class DoctorCommand : CliktCommand("doctor") {
    override fun help(context: Context): String = "List the ways to OpenGL on this machine, or why one is not available."

    private class Finding(
        val kind: ContextKind,
        val works: Boolean,
        val text: String,
    )

    override fun run() {
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
