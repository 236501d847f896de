package cga.grading.findings

import cga.imaging.JsonNode

/** How much of everything findings may hold. */
internal object Limit {
    val CHECKS = Check.entries.size
    val MISTAKES = Mistake.entries.size * 8
    const val PLOTS = 64
    const val POINTS = 4096
    const val PICTURES = 96
    const val NOTES = 200
    const val DETAILS = 32
    const val PLACES = 8
    const val LINE = 1_000_000
    const val TEXT = 4000
}

/** What a picture beside the findings may be called: no folder, nothing hidden, nothing that a shell or a page might take for more. */
internal val PICTURE_NAME: Regex = Regex("""[A-Za-z0-9][A-Za-z0-9._-]{0,99}\.png""")

/** Reads what [findingsJson] writes, from whoever it comes. */
internal object FindingsReader {
    private val checks = Check.entries.associateBy { it.id }
    private val mistakes = Mistake.entries.associateBy { it.id }

    fun findings(node: JsonNode): Findings {
        node.allowOnly("checks", "mistakes", "plots", "pictures", "notes", "proof")
        val measured = node.list("checks", Limit.CHECKS).map(::measured)
        measured.groupBy { it.check }.values.find { it.size > 1 }?.let { node.fail("\"checks\" has ${it[0].check.id} more than once.") }
        return Findings(
            measured,
            node.list("mistakes", Limit.MISTAKES).map(::found),
            node.list("plots", Limit.PLOTS).map(::plot),
            node.list("pictures", Limit.PICTURES).map(::evidence),
            node.list("notes", Limit.NOTES).map { MessageReader(it).message() },
            node.find("proof")?.let(::proof),
        )
    }

    private fun measured(node: JsonNode): Measured {
        node.allowOnly("check", "error", "absent", "said")
        val check = check(node.get("check"))
        val message = MessageReader(node.get("said")).message()
        val error = node.find("error")?.number("a number from 0") {
            it.toDoubleOrNull()?.takeIf { error ->
                error.isFinite() && error >= 0
            }
        }
        return when {
            node.find("absent")?.flag() == true -> Measured.absent(check, message)
            error == null -> Measured.open(check, message)
            else -> Measured.of(check, error, message)
        }
    }

    private fun found(node: JsonNode): Found {
        node.allowOnly("mistake", "fit", "difference", "where", "alternatives", "explains", "details", "places", "proof")
        return Found(
            mistake(node.get("mistake")),
            node.get("fit").finite(),
            node.get("difference").finite(),
            node.get("where").limited(),
            node.list("alternatives", Limit.MISTAKES).map(::mistake),
            node.find("explains")?.let(::explained),
            node.list("details", Limit.DETAILS).map { MessageReader(it).message() },
            node.list("places", Limit.PLACES).map(::place),
            node.find("proof")?.let(::proof),
        )
    }

    private fun place(node: JsonNode): Place {
        node.allowOnly("file", "line", "first", "source")
        val source = node.list("source", Place.MOST_LINES).map { it.limited() }
        return Place(node.get("file").limited(), line(node.get("line")), source, line(node.get("first")))
    }

    private fun line(node: JsonNode): Int = node.number("a line's number") { text -> text.toIntOrNull()?.takeIf { it in 0..Limit.LINE } }

    private fun proof(node: JsonNode): Proof {
        node.allowOnly("explained", "left")
        return Proof(node.get("explained").finite(), node.get("left").finite())
    }

    private fun explained(node: JsonNode): Set<Check> =
        node.limited().split(' ').filter { it.isNotEmpty() }.map { checks[it] ?: node.fail("\"$it\" is no check.") }.toSet()

    private fun plot(node: JsonNode): Plot {
        node.allowOnly("check", "title", "xLabel", "yLabel", "x", "measured", "expected")
        val (x, measured, expected) = listOf("x", "measured", "expected").map {
            node.list(it, Limit.POINTS).map { value ->
                value.finite()
            }
        }
        if (x.size != measured.size ||
            x.size != expected.size
        ) {
            node.fail("its curves have ${measured.size} and ${expected.size} points for ${x.size} x.")
        }
        return Plot(
            check(node.get("check")),
            node.get("title").limited(),
            node.get("xLabel").limited(),
            node.get("yLabel").limited(),
            x.toDoubleArray(),
            measured.toDoubleArray(),
            expected.toDoubleArray(),
        )
    }

    private fun evidence(node: JsonNode): Evidence {
        node.allowOnly("check", "title", "measured", "expected")
        return Evidence(
            node.find("check")?.let(::check),
            MessageReader(node.get("title")).message(),
            picture(node.get("measured")),
            node.find("expected")?.let(::picture),
        )
    }

    private fun picture(node: JsonNode): String =
        node.text().also { if (!PICTURE_NAME.matches(it)) node.fail("must be the plain name of a PNG file beside this one.") }

    private fun check(node: JsonNode): Check = checks[node.text()] ?: node.fail("\"${node.text().take(SHOWN)}\" is no check.")

    private fun mistake(node: JsonNode): Mistake = mistakes[node.text()] ?: node.fail("\"${node.text().take(SHOWN)}\" is no mistake.")

    private fun JsonNode.finite(): Double = number("a finite number") { it.toDoubleOrNull()?.takeIf(Double::isFinite) }

    private fun JsonNode.limited(): String =
        optionalText().also { if (it.length > Limit.TEXT) fail("is ${it.length} characters long; at most ${Limit.TEXT} are read.") }

    /** The list called [name], which may be left away. */
    private fun JsonNode.list(name: String, limit: Int): List<JsonNode> {
        val values = find(name)?.list().orEmpty()
        if (values.size > limit) fail("\"$name\" has ${values.size} entries; at most $limit are read.")
        return values
    }

    private const val SHOWN = 100
}
