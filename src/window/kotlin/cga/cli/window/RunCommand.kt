package cga.cli.window

import cga.cli.RenderCommand
import cga.cli.sizeOption
import cga.cli.stepOption
import cga.framework.Display
import cga.inspect.InspectedGame
import com.github.ajalt.clikt.core.CliktCommand
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import com.github.ajalt.clikt.parameters.types.int

/** `cga run`: the scene in a window, or as a picture where there is no display. */
internal class RunCommand : CliktCommand("run") {
    override fun help(context: Context): String = "Open the scene in a window. ${InspectedGame.HELP}."

    private val step by stepOption()
    private val size by sizeOption()
    private val fullscreen by option("--fullscreen", help = "Take the whole screen").flag()
    private val samples by option("--samples", metavar = "N", help = "Samples a pixel. Default: 4").int().default(4)

    private val language by option("--lang", help = "Language of keys and panel: de or en. Default: the system's").choice("de", "en")

    override fun run() {
        language?.let { System.setProperty("cga.lang", it) }
        if (!Display.isPresent) {
            echo("no display here: rendering off screen to motorcycle.png", err = true)
            val picture = listOf("--step", step.sheet, "--size", "${size.width}x${size.height}", "--samples", "$samples")
            return RenderCommand().parse(picture)
        }
        echo(InspectedGame.HELP, err = true)
        InspectedGame(size.width, size.height, fullscreen, samples, step).run()
    }
}
