package cga.measure.accuracy

import cga.exercise.game.Step
import cga.reference.ReferencePicture
import java.nio.ByteBuffer
import java.util.Locale
import java.util.zip.CRC32
import kotlin.math.abs
import kotlin.math.max

/** Every step drawn by OpenGL into a float target, against the reference. */
public object GlAgainstTruth {
    /**
     * The figures of [steps] under each of [filterings]; about a second a step. Each filtering gets a process of its own.
     *
     * Throws [cga.framework.InputError] where there is no OpenGL.
     */
    public fun measure(
        steps: List<Step> = Step.entries,
        filterings: List<TextureFiltering> = TextureFiltering.entries,
    ): List<GlFigure> {
        val truths = HashMap<Pair<Step, TruthView>, GlAgainstTruthPicture>()
        return filterings.flatMap { filtering ->
            GlAgainstTruthProcess(filtering, steps).use { gl ->
                steps.flatMap { step ->
                    TruthView.entries.flatMap { view ->
                        val truth = truths.getOrPut(
                            step to view,
                        ) { GlAgainstTruthPicture(view.frame(step), view.width, view.height, gl.grid) }
                        Comparison(gl, step, view, filtering, truth).figures()
                    }
                }
            }
        }
    }

    /** A table of fewer pixels says nothing. */
    private const val FEWEST = 1000

    /**
     * Markdown: a table for every group of pixels, with a line for each of [figures], except that a filtering which changed no bit of a
     * picture has no line of its own. Under them, in how many pixels another triangle is seen.
     */
    public fun table(figures: List<GlFigure>): String {
        val head =
            "| step | texture filter | pixels | max | 99.9 % | mean | relative max | mean " +
                "| worst pixel: what is off there | allowed there, median | most used |"
        val rule = "|---|---|--:|--:|--:|--:|--:|--:|---|--:|--:|"
        val tables =
            TexelGroup.entries.mapNotNull { group ->
                val lines = figures.filter { it.group == group && it.pixels >= FEWEST }.distinctBy { it.step to it.checksum }.map(::row)
                if (lines.isEmpty()) null else (listOf("**${group.title}**", "", head, rule) + lines).joinToString("\n")
            }
        return (tables + silhouettes(figures)).joinToString("\n\n")
    }

    private fun row(figure: GlFigure): String =
        figure.run {
            val place = "(${worst.first}, ${worst.second}): $term, ${short(termError)}"
            val relative = listOf(maxRelative, meanRelative).map { "${short(100 * it)} %" }
            val allowed = "${short(worstBound)}, ${short(medianBound)}"
            val filter = if (isLlvmpipe) filtering.title else "the driver's"
            val cells = listOf(step.sheet, filter, "$pixels") + listOf(max, p999, mean).map(::short) + relative + place + allowed
            (cells + "${short(100 * tightness)} %").joinToString(" | ", "| ", " |")
        }

    private fun silhouettes(figures: List<GlFigure>): String {
        val pictures = figures.filter { it.group == TexelGroup.MINIFIED }
        val least = pictures.minOfOrNull { it.agreement } ?: 1.0
        val magnified = figures.filter { it.group == TexelGroup.MAGNIFIED }
        return "Drawn by ${figures.map { it.renderer }.distinct().joinToString()}. Both show the same triangle, or none, in at least " +
            "%.3f %% of a picture's pixels; ".format(Locale.ROOT, 100 * least) +
            "in the others, all but ${figures.sumOf { it.strays }}, an edge passes within 1/256 of a pixel of the centre. " +
            "No texture is minified in ${magnified.minOfOrNull {
                it.pixels
            }} to ${magnified.maxOfOrNull { it.pixels }} pixels of a picture, " +
            "where the error is at most ${short(magnified.maxOfOrNull { it.max } ?: 0.0)}." + quadLod(figures)
    }

    private fun quadLod(figures: List<GlFigure>): String {
        val both = figures.groupBy { it.step to it.group }.values.filter { it.checksum(TextureFiltering.FLOATS_EACH_PIXEL) != null }
        val changed = both.count { it.checksum(TextureFiltering.FLOATS) != it.checksum(TextureFiltering.FLOATS_EACH_PIXEL) }
        return if (both.isEmpty()) "" else " `no_quad_lod` changed $changed of ${both.size} lines."
    }

    private fun List<GlFigure>.checksum(filtering: TextureFiltering) = find { it.filtering == filtering }?.checksum

    /** Three digits, with no more zeros before them than it takes. */
    private fun short(x: Double): String =
        when {
            x == 0.0 -> "0"
            x < 1e-3 -> "%.0e".format(Locale.ROOT, x)
            x < 1 -> "%.3f".format(Locale.ROOT, x)
            else -> "%.1f".format(Locale.ROOT, x)
        }

    /** One picture and its truth. */
    private class Comparison(
        private val gl: GlAgainstTruthProcess,
        private val step: Step,
        private val view: TruthView,
        private val filtering: TextureFiltering,
        private val truth: GlAgainstTruthPicture,
    ) {
        private val shot = gl.shot(step, view)
        private val isLlvmpipe = GlFigure.isLlvmpipe(gl.renderer)
        private val bytes = isLlvmpipe && filtering == TextureFiltering.BYTES
        private val surface = truth.surface
        private val differing = surface.indices.filter { surface[it] != shot.surface[it] }
        private val seen = surface.indices.filter { surface[it] != ReferencePicture.NO_SURFACE && surface[it] == shot.surface[it] }

        fun figures(): List<GlFigure> {
            if (view == TruthView.FIRST_LEVEL) return listOf(figure(TexelGroup.FIRST_LEVEL, seen, TrueLevels.IDEAL))
            val (minified, magnified) = seen.partition { truth.isMinified[it] }
            val figures =
                listOf(
                    figure(TexelGroup.MAGNIFIED, magnified, TrueLevels.IDEAL),
                    figure(TexelGroup.MINIFIED, minified, TrueLevels.IDEAL),
                )
            return if (isLlvmpipe) figures + figure(TexelGroup.KNOWN_LEVELS, seen, TrueLevels.DRIVER) else figures
        }

        private fun figure(
            group: TexelGroup,
            pixels: List<Int>,
            levels: TrueLevels,
        ): GlFigure {
            val rgb = truth.rgb(levels)
            val bound = truth.bound(levels, bytes)
            val errors = pixels.map { pixel -> 255 * (0..2).maxOf { error(rgb, pixel, it) } }
            val sorted = errors.sorted()
            val relative = pixels.mapIndexed { i, pixel -> errors[i] / max(255 * (0..2).maxOf { rgb[3 * pixel + it] }, 1.0) }
            val shares = pixels.map { pixel -> (0..2).maxOf { share(error(rgb, pixel, it), bound[3 * pixel + it]) } }
            val bounds = pixels.map { pixel -> 255 * (0..2).maxOf { bound[3 * pixel + it] } }
            val worst = if (errors.isEmpty()) null else pixels[errors.indices.maxBy { errors[it] }]
            val (term, termError) = if (worst == null) "" to 0.0 else worstTerm(worst, levels)
            return GlFigure(
                renderer = gl.renderer,
                step = step,
                filtering = filtering,
                group = group,
                agreement = 1 - differing.size.toDouble() / surface.size,
                strays = differing.count { !truth.mayShow(it, shot.surface[it]) },
                checksum = checksum(),
                pixels = pixels.size,
                max = sorted.lastOrNull() ?: 0.0,
                p999 = sorted.getOrElse((0.999 * sorted.size).toInt()) { 0.0 },
                mean = if (errors.isEmpty()) 0.0 else errors.average(),
                maxRelative = relative.maxOrNull() ?: 0.0,
                meanRelative = if (errors.isEmpty()) 0.0 else relative.average(),
                worst = if (worst == null) 0 to 0 else worst % truth.width to worst / truth.width,
                term = term,
                termError = termError,
                worstBound = if (worst == null) 0.0 else 255 * (0..2).maxOf { bound[3 * worst + it] },
                medianBound = bounds.sorted().getOrElse(bounds.size / 2) { 0.0 },
                tightness = shares.maxOrNull() ?: 0.0,
                unbounded = bounds.count { it.isInfinite() },
            )
        }

        private fun error(
            rgb: DoubleArray,
            pixel: Int,
            channel: Int,
        ) = abs(rgb[3 * pixel + channel] - shot.picture.rgba[4 * pixel + channel])

        /** NaN, which a picture must not hold, counts as any excess. */
        private fun share(
            error: Double,
            bound: Double,
        ) = if (error.isNaN()) {
            Double.POSITIVE_INFINITY
        } else if (error == 0.0) {
            0.0
        } else {
            error / bound
        }

        /** The term that is furthest off at [pixel], found by drawing each of them alone, and by how much. */
        private fun worstTerm(
            pixel: Int,
            levels: TrueLevels,
        ): Pair<String, Double> {
            val point = truth.point(pixel, levels)
            val drawn = gl.terms(step, view, pixel % truth.width, pixel / truth.width)
            return GlAgainstTruthTerm
                .all(truth.frame)
                .mapIndexed { i, term -> term.name to 255 * (0..2).maxOf { abs(term.of(point)[it] - drawn[3 * i + it]) } }
                .maxBy { it.second }
        }

        private fun checksum(): Long {
            val picture = ByteBuffer.allocate(4 * shot.picture.rgba.size).also { it.asFloatBuffer().put(shot.picture.rgba) }
            return CRC32().apply { update(picture.array()) }.value
        }
    }
}
