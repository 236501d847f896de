package cga.cli.grader

import cga.grading.starter.StarterExport
import cga.grading.starter.StarterLanguage
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.path
import java.util.Locale

/** `cga starter`: what students begin with. */
internal class StarterCommand : CliktCommand("starter") {
    override fun help(
        context: Context,
    ): String = "Write the project that students fill in: the course's own, a TODO for each task, and the window beside it as a library."

    private val folder by argument("DIR", help = "A folder that does not exist yet, or is empty").path()

    private val language by option("--lang", help = "Language of the tasks: de or en. Default: the system's")
        .choice(StarterLanguage.entries.associateBy { it.code })

    override fun run() {
        val german = Locale.getDefault().language == StarterLanguage.GERMAN.code
        StarterExport.write(folder, language ?: if (german) StarterLanguage.GERMAN else StarterLanguage.ENGLISH)
        echo("$folder: open it in IntelliJ IDEA, or type: cd $folder && ./cga run", err = true)
    }
}
