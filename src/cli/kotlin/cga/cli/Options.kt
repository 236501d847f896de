package cga.cli

import cga.exercise.game.Step
import cga.framework.context.ContextKind
import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.options.OptionWithValues
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import java.nio.file.Path

// The options that several commands share.

/** Width and height in pixels. */
public data class Size(
    public val width: Int,
    public val height: Int,
)

public fun ParameterHolder.stepOption(): OptionWithValues<Step, Step, Step> =
    option("--step", metavar = "STEP", help = "Step of the sheet: ${steps()}. Default: ${Step.FINAL.sheet}")
        .convert { Step.of(it) ?: fail("$it is not a step of the sheet: use ${steps()}") }
        .default(Step.FINAL)

public fun ParameterHolder.sizeOption(): OptionWithValues<Size, Size, Size> =
    option("--size", metavar = "WxH", help = "Size of the picture in pixels. Default: 1280x720")
        .convert { text ->
            val sides = Regex("""(\d{1,9})x(\d{1,9})""").matchEntire(text)?.groupValues?.drop(1)?.map(String::toInt)
            if (sides == null || sides.any { it == 0 }) fail("$text is not a size: write width x height, both at least 1, as in 1280x720")
            Size(sides[0], sides[1])
        }.default(Size(1280, 720))

public fun ParameterHolder.contextOption(): OptionWithValues<ContextKind?, ContextKind, ContextKind> =
    option("--context", help = "Where OpenGL comes from. Default: the first that works")
        .choice(ContextKind.entries.associateBy { it.name.lowercase() })

/** The same for a command that can do without OpenGL. */
public fun ParameterHolder.rendererOption(): OptionWithValues<Renderer, Renderer, Renderer> =
    option("--context", help = "Where OpenGL comes from; reference: shade on the CPU, in double precision. Default: the first that works")
        .choice(ContextKind.entries.associate { it.name.lowercase() to Renderer.OpenGL(it) } + ("reference" to Renderer.Reference))
        .default(Renderer.OpenGL(null))

/** Throws a usage error unless [ok]. */
public fun requireUsage(
    ok: Boolean,
    message: () -> String,
) {
    if (!ok) throw UsageError(message())
}

/** Throws a usage error where the name of [file], the value of [option], ends as one of another kind than these [endings]; it may have none. */
public fun requireEnding(
    option: String,
    file: Path?,
    vararg endings: String,
) {
    val name = file?.fileName?.toString().orEmpty()
    requireUsage('.' !in name.drop(1) || endings.any { name.endsWith(it, ignoreCase = true) }) {
        "$option $file: it would hold a picture of another kind than its name says; end it in ${endings.joinToString(" or ")}"
    }
}

/** The name of picture [frame] (from 0) of [frames]: `FILE-0001.png` and so on, the name itself where there is one only. */
public fun numbered(
    file: Path,
    frame: Int,
    frames: Int,
): Path {
    if (frames == 1) return file
    val name = file.fileName.toString()
    val stem = name.substringBeforeLast('.')
    return file.resolveSibling("$stem-%04d".format(frame + 1) + name.removePrefix(stem))
}

private fun steps(): String = Step.entries.joinToString { it.sheet }
