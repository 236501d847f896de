package cga.cli.grader

import cga.grading.starter.StarterExport
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.types.path

/** `cga starter`: what students begin with. */
internal class StarterCommand : CliktCommand("starter") {
    override fun help(
        context: Context,
    ): String = "Write the project that students fill in: this one without its solutions, a TODO for each."

    private val folder by argument("DIR", help = "A folder that does not exist yet, or is empty").path()

    override fun run() {
        StarterExport.write(folder)
        echo("$folder: open it in IntelliJ IDEA, or type: cd $folder && ./gradlew run (or: mvn compile exec:exec)", err = true)
    }
}
