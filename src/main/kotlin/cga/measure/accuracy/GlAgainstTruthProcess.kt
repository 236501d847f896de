package cga.measure.accuracy

import cga.exercise.game.Step
import cga.framework.InputError
import java.nio.file.Files
import java.nio.file.Path

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

/** A process that draws [steps] with [filtering]. Throws [InputError] where it cannot. */
internal class GlAgainstTruthProcess(
    filtering: TextureFiltering,
    steps: List<Step>,
) : AutoCloseable {
    private val folder = Files.createTempDirectory("cga-truth")
    private val process = start(filtering, steps)
    private val answers = process.inputReader()
    private val questions = process.outputWriter()
    private val greeting: List<String> =
        (
            answers.readLine() ?: throw InputError(
                "OpenGL cannot be measured; the reason is above, and ./cga doctor tells more.",
            )
        ).split(' ', limit = 2)

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
    ): List<Double> {
        questions.write("${step.name} ${view.name} $column $row\n")
        questions.flush()
        return checkNotNull(answers.readLine()) { "the process that draws ended early" }.split(' ').map { it.toDouble() }
    }

    override fun close() {
        questions.close()
        process.waitFor()
        folder.toFile().deleteRecursively()
    }

    private fun start(
        filtering: TextureFiltering,
        steps: List<Step>,
    ): Process {
        val home = System.getProperty("cga.home")?.let { listOf("-Dcga.home=$it") }.orEmpty()
        val native = if (Runtime.version().feature() < 24) emptyList() else listOf("--enable-native-access=ALL-UNNAMED")
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val main = listOf("-cp", System.getProperty("java.class.path"), "cga.measure.accuracy.GlAgainstTruthShooter", "$folder")
        val options = listOf("-XX:TieredStopAtLevel=1", "-Djava.awt.headless=true") + native + home
        val builder = ProcessBuilder(listOf(java) + options + main + steps.map { it.name })
        builder.environment()["GALLIVM_PERF"] = filtering.gallivm
        return builder.redirectError(ProcessBuilder.Redirect.INHERIT).start()
    }
}
