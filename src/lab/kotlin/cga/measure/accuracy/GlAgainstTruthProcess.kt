package cga.measure.accuracy

import cga.exercise.game.Step
import java.nio.file.Files

/** How llvmpipe filters textures; other drivers take no notice of its variable `GALLIVM_PERF`. */
public enum class TextureFiltering(
    public val title: String,
    internal val gallivm: String,
) {
    /** In bytes, as it does when left alone. */
    BYTES("8-bit", ""),

    /** In floats. */
    FLOATS("float", "no_aos_sampling"),

    /** In floats, and with a λ for every pixel where it would otherwise share one within a quad. */
    FLOATS_EACH_PIXEL("float, λ for each pixel", "no_aos_sampling,no_quad_lod"),
}

/** A process that draws [steps] with [filtering]. Throws [cga.framework.InputError] where it cannot. */
internal class GlAgainstTruthProcess(
    filtering: TextureFiltering,
    steps: List<Step>,
) : AutoCloseable {
    private val folder = Files.createTempDirectory("cga-truth")
    private val worker =
        Worker(
            "the process that draws with OpenGL",
            GlAgainstTruthShooter::class.java.name,
            listOf("$folder") + steps.map { it.name },
            environment = mapOf("GALLIVM_PERF" to filtering.gallivm),
        )
    private val greeting = worker.answer().split(' ', limit = 2)

    /** Steps of the sub-pixel grid in a pixel. */
    val grid: Int = 1 shl greeting[0].toInt()

    /** `GL_RENDERER`. */
    val renderer: String = greeting[1]

    fun shot(
        step: Step,
        view: TruthView,
    ): GlAgainstTruthShot = GlAgainstTruthShot.read(GlAgainstTruthShot.file(folder, step, view), view.width, view.height)

    /** Three numbers for each of [GlAgainstTruthTerm.all], at a pixel from the upper left. */
    fun terms(
        step: Step,
        view: TruthView,
        column: Int,
        row: Int,
    ): List<Double> = worker.ask("${step.name} ${view.name} $column $row").split(' ').map { it.toDouble() }

    override fun close() {
        worker.close()
        folder.toFile().deleteRecursively()
    }
}
