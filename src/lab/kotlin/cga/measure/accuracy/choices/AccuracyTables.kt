package cga.measure.accuracy.choices

import cga.framework.context.ContextKind
import cga.measure.accuracy.GlAgainstTruth
import cga.measure.accuracy.MatrixAccuracy
import cga.measure.accuracy.hard.HardCases

/**
 * How much is measured.
 *
 * @param runs of everything that is timed, interleaved.
 * @param size of the pictures.
 * @param context a GPU's, which is measured beside llvmpipe; null for llvmpipe alone.
 * @param say what is being done, one line at a time.
 */
public class AccuracySettings(
    public val runs: Int,
    public val size: PictureSize,
    public val context: ContextKind?,
    public val say: (String) -> Unit,
)

/** What was measured: [contents] by the document's markers, and the [plots] that they show. */
public class Measurement(
    public val contents: Map<String, String>,
    public val plots: List<ParetoPlot> = emptyList(),
)

/** The parts of docs/accuracy.md that are measured. */
public object AccuracyTables {
    /** One part: which markers it fills, and how. */
    public class Part(
        public val markers: List<String>,
        public val measure: (AccuracySettings) -> Measurement,
    )

    /** All parts by name. */
    public val all: Map<String, Part> =
        mapOf(
            table("gl-against-truth") { GlAgainstTruth.table(GlAgainstTruth.measure()) },
            table("hard-cases") { HardCases.table() },
            table("matrices") { MatrixTable.of(MatrixAccuracy.measure()) },
            "choices" to Part(listOf(ChoicesReport.TABLE, ChoicesReport.PLOT)) { ChoicesReport(it).measure() },
        )

    /** A part that is one table, and needs no settings. */
    private fun table(
        name: String,
        markdown: () -> String,
    ) = name to Part(listOf("table:$name")) { Measurement(mapOf("table:$name" to markdown())) }
}
