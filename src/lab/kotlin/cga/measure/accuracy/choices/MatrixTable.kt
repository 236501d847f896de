package cga.measure.accuracy.choices

import cga.measure.accuracy.Figure

/** Largest errors of the matrix libraries, in ulps of a float: a row for every kind of case, a column for every library and its options. */
internal object MatrixTable {
    fun of(figures: List<Figure>): String {
        val columns = figures
            .filter {
                it.implementation == "JOML float" || it.options.isEmpty()
            }.map { it.implementation to it.options }
            .distinct()
        val header = "| operation | cases | ${columns.joinToString(" | ") { (name, options) -> title(name, options) }} |"
        val rows =
            figures.groupBy { it.operation to it.kind }.map { (key, ofKind) ->
                val cells = columns.map { column -> ofKind.find { it.implementation to it.options == column }?.let(::cell) ?: "" }
                "| ${key.first.label} | ${key.second} | ${cells.joinToString(" | ")} |"
            }
        return "$header\n|---|---|${"---:|".repeat(columns.size)}\n${rows.joinToString("\n")}"
    }

    private fun title(
        name: String,
        options: String,
    ) = if (options.isEmpty()) name else "… ${options.replace("joml.", "").replace(" ", ", ")}"

    private fun cell(figure: Figure): String {
        val error = if (figure.maxUlp.isNaN()) "" else MeasuredGroup.digits(figure.maxUlp)
        return if (figure.notFinite == 0) error else "$error NaN: ${figure.notFinite} of ${figure.cases}".trim()
    }
}
