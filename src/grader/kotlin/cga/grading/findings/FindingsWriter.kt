package cga.grading.findings

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/** [findings] as JSON text. Empty lists are left away. */
internal fun findingsJson(findings: Findings): String {
    val json =
        buildJsonObject {
            putList("checks", findings.checks, Limit.CHECKS, ::measured)
            putList("mistakes", findings.mistakes, Limit.MISTAKES, ::found)
            putList("plots", findings.plots, Limit.PLOTS, ::plot)
            putList("pictures", findings.pictures, Limit.PICTURES, ::evidence)
            putList("notes", findings.notes.take(Limit.NOTES), Limit.NOTES, ::messageJson)
            findings.proof?.let { put("proof", proof(it)) }
        }
    return PRETTY.encodeToString(JsonElement.serializer(), json) + "\n"
}

private val PRETTY =
    Json {
        prettyPrint = true
        prettyPrintIndent = "  "
    }

private fun measured(measured: Measured) =
    buildJsonObject {
        put("check", measured.check.id)
        measured.error?.takeIf { it.isFinite() && it >= 0 }?.let { put("error", it) }
        if (measured.standing == Standing.ABSENT) put("absent", true)
        put("said", messageJson(measured.message))
    }

private fun found(found: Found) =
    buildJsonObject {
        put("mistake", found.mistake.id)
        put("fit", finite(found.fit, found.mistake.id))
        put("difference", finite(found.difference, found.mistake.id))
        put("where", found.where.take(Limit.TEXT))
        putList("alternatives", found.alternatives.distinct(), Limit.MISTAKES) { JsonPrimitive(it.id) }
        // An empty list says something: that it explains nothing else. JSON lists of ours are never empty, so it is a text.
        found.explains?.let { put("explains", it.joinToString(" ") { check -> check.id }) }
        putList("details", found.details, Limit.DETAILS, ::messageJson)
        putList("places", found.places.take(Limit.PLACES), Limit.PLACES, ::place)
        found.proof?.let { put("proof", proof(it)) }
    }

private fun place(place: Place) =
    buildJsonObject {
        put("file", place.file.take(Limit.TEXT))
        put("line", place.line)
        put("first", place.first)
        putList("source", place.source, Place.MOST_LINES) { JsonPrimitive(it.take(Place.LONGEST)) }
    }

private fun proof(proof: Proof) =
    buildJsonObject {
        put("explained", finite(proof.explained, "explained"))
        put("left", finite(proof.left, "left"))
    }

private fun plot(plot: Plot): JsonObject {
    require(plot.x.size == plot.measured.size && plot.x.size == plot.expected.size) {
        "${plot.title}: ${plot.x.size} x, ${plot.measured.size} measured and ${plot.expected.size} expected are no curves"
    }
    // What was not measured is no point of the curve.
    val points = plot.x.indices.filter { i -> plot.x[i].isFinite() && plot.measured[i].isFinite() && plot.expected[i].isFinite() }
    return buildJsonObject {
        put("check", plot.check.id)
        put("title", plot.title.take(Limit.TEXT))
        put("xLabel", plot.xLabel.take(Limit.TEXT))
        put("yLabel", plot.yLabel.take(Limit.TEXT))
        putList("x", points, Limit.POINTS) { JsonPrimitive(plot.x[it]) }
        putList("measured", points, Limit.POINTS) { JsonPrimitive(plot.measured[it]) }
        putList("expected", points, Limit.POINTS) { JsonPrimitive(plot.expected[it]) }
    }
}

private fun evidence(evidence: Evidence) =
    buildJsonObject {
        evidence.check?.let { put("check", it.id) }
        put("title", messageJson(evidence.title))
        put("measured", plain(evidence.measured))
        evidence.expected?.let { put("expected", plain(it)) }
    }

private fun plain(name: String) = name.also { require(PICTURE_NAME.matches(it)) { "\"$it\" is no plain name of a PNG file" } }

private fun finite(value: Double, what: String) = value.also { require(it.isFinite()) { "$what: $it is not finite" } }

private fun <T> JsonObjectBuilder.putList(name: String, values: List<T>, limit: Int, json: (T) -> JsonElement) {
    require(values.size <= limit) { "${values.size} $name are more than $limit" }
    if (values.isNotEmpty()) put(name, JsonArray(values.map(json)))
}
