package cga.measure.accuracy.choices

import cga.measure.accuracy.MatrixAccuracy

/** Speed against error for every choice: one table for each group, and the plots of them. */
internal class ChoicesReport(private val settings: AccuracySettings) {
    private val missing = ArrayList<String>()

    fun measure(): Measurement {
        val load = Host.load()
        settings.say("drawing with llvmpipe")
        val drawing = DrawingMeasurement(settings.size, settings.runs)
        val software = drawing.measure(Device(null, software = true))
        val gpu = gpu(drawing)
        settings.say("shading with the reference")
        val reference = drawing.reference()
        settings.say("computing matrices")
        val matrices = MatrixMeasurement(settings.runs).measure(MatrixAccuracy.measure(), missing::add)

        val gpuGroups = gpu?.groups.orEmpty().map {
            MeasuredGroup(
                "${it.title}, ${gpu?.renderer}",
                it.note,
                it.costUnit,
                it.errorUnit,
                it.rows,
            )
        }
        val groups = software.groups + gpuGroups + reference + matrices
        val introduction =
            "${Host.describe(
                software.renderer,
                software.version,
            )}. ${settings.runs} runs, interleaved: median, lowest and highest; what differs by less than they " +
                "do differs by chance. Load average at the start: $load. ${missing.joinToString(" ") { "$it." }}"
        val plots = plots(software.groups, matrices)
        val tables = groups.joinToString("\n\n") { it.toMarkdown() }
        return Measurement(mapOf(TABLE to "$introduction\n\n$tables", PLOT to plots.joinToString("\n\n", transform = ::link)), plots)
    }

    private fun gpu(drawing: DrawingMeasurement): DrawingResult? {
        val kind = settings.context
        if (kind == null) {
            missing += "No GPU was measured (`./cga accuracy --context egl` adds the rows of one)"
            return null
        }
        settings.say("drawing with ${kind.name.lowercase()}")
        val result = drawing.measure(Device(kind, software = false))
        if (!result.isSoftware) return result
        missing += "No GPU was at hand: `--context ${kind.name.lowercase()}` gives ${result.renderer}"
        return null
    }

    private fun plots(
        drawing: List<MeasuredGroup>,
        matrices: List<MeasuredGroup>,
    ): List<ParetoPlot> {
        val byTitle = drawing.associateBy { it.title }
        val large = listOf(DrawingGroup.LIGHTING, DrawingGroup.TARGET, DrawingGroup.FILTER).map { byTitle.getValue(it.title) }
        val small = byTitle.getValue(DrawingGroup.ANTIALIASING.title)
        val mean = "mean error against the truth, 1/255"
        val size = settings.size
        val (ours, reference) = small.rows.partition { !it.name.startsWith("reference") }
        return listOf(
            ParetoPlot(
                "accuracy-drawing", "Drawing step 4.7, $size", "ms a frame", mean,
                large.associate {
                    it.title to it.rows
                },
                Measured::mean,
            ),
            ParetoPlot(
                "accuracy-antialiasing",
                "Antialiasing, ${size.small}",
                "ms a picture",
                mean,
                mapOf("OpenGL" to ours, "reference" to reference),
                Measured::mean,
            ),
            ParetoPlot(
                "accuracy-matrices",
                MatrixTask.MODEL_VIEW.title,
                "ns",
                "largest error, ulp of a float",
                matrices.single { it.title == MatrixTask.MODEL_VIEW.title }.rows.groupBy { it.name.substringBefore(' ') },
                Measured::max,
            ),
        )
    }

    private fun link(plot: ParetoPlot) = "![${plot.title}: time against error](images/${plot.name}.svg)"

    companion object {
        const val TABLE = "table:choices"
        const val PLOT = "plot:choices"
    }
}
