package cga.imaging.report

/** One case of a report with its pictures made ready; [id] is its anchor on the page. */
internal class CaseView(
    val id: String,
    val case: ReportCase,
) {
    /** What is to be seen where nothing differs: the picture that both are, or the only one that there is. */
    val picture: EmbeddedPicture?

    /** What is to be seen where pictures differ. */
    val pair: PairView?

    /** Exposure in stops where the pictures hold floats. */
    val exposure: Int?

    private val pictures: List<EmbeddedPicture>

    init {
        val comparison = case.comparison
        val only = if (comparison == null) case.picture else comparison.expected.takeIf { comparison.isIdentical }
        val display = (only ?: comparison?.expected)?.let(Display::of)
        exposure = display?.exposure
        picture =
            if (only == null || display == null) null else EmbeddedPicture("$id-picture", "Picture of ${case.name}", display.draw(only))
        pair = if (only != null || comparison == null || display == null) null else PairView(id, case.name, comparison, display)
        pictures = listOfNotNull(picture) + pair?.pictures.orEmpty()
    }

    /** Bytes that its large pictures take on the page. */
    val size: Int get() = pictures.sumOf { it.size }

    /** By how much less wide and high the large pictures are drawn than they are. */
    val reduction: Int get() = pictures.maxOfOrNull { it.reduction } ?: 1

    /** Draws the large pictures with half their present width and height. */
    fun halve(): Unit = pictures.forEach { it.halve() }
}
