package cga.grading.rubric

import cga.framework.Home
import cga.framework.InputError
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.sandbox.Temporary
import cga.imaging.JsonNode
import java.nio.file.Files
import java.nio.file.Path
import java.security.MessageDigest
import kotlin.io.path.deleteIfExists
import kotlin.io.path.writeBytes

/**
 * What each check is worth and how exact it has to be, from a JSON file that instructors edit:
 *
 *     { "name": "…",
 *       "checks": { "4.2.light": { "points": 4, "tolerance": 0.02, "zero": 0.5, "why": "…" }, … },
 *       "mistakes": { "attenuation-other-k": 0.5 } }
 *
 * Every check stands in it, one that does not count with 0 points. Under `mistakes` stand those that cost less than all of their check.
 *
 * @param fingerprint of the file's bytes: two rubrics with the same give the same points.
 */
public class Rubric private constructor(
    public val name: String,
    private val rules: Map<Check, CheckRule>,
    private val costs: Map<Mistake, Double>,
    public val fingerprint: String,
) {
    /** What can be reached. */
    public val total: Double = rules.values.sumOf { it.points }

    /** The rule of [check]. */
    public fun rule(check: Check): CheckRule = rules.getValue(check)

    /** The share of its check's points that [mistake] costs, 0 to 1. */
    public fun cost(mistake: Mistake): Double = costs[mistake] ?: 1.0

    public companion object {
        private const val MAX_BYTES = 1L shl 20
        private const val MOST_POINTS = 10_000.0
        private const val MOST_ERROR = 1000.0

        /** Our own: 100 points over the tasks 4.2 to 4.7. */
        public fun default(): Rubric {
            val bytes = defaultBytes()
            val file = Temporary.file("rubric")
            try {
                file.writeBytes(bytes)
                return read(file)
            } finally {
                file.deleteIfExists()
            }
        }

        /** The file that [default] is read from, to start one's own with. */
        public fun defaultBytes(): ByteArray =
            checkNotNull(Rubric::class.java.getResource("rubric.json")) { "rubric.json is missing from the program" }.readBytes()

        /** The rubric in [file]. Throws [InputError] naming the file, the key and the cure. */
        public fun read(file: Path): Rubric {
            if (Files.exists(file) && !Files.isDirectory(file) && Files.size(file) > MAX_BYTES) {
                throw InputError("rubric file $file is larger than $MAX_BYTES bytes: is it a rubric?")
            }
            val node = JsonNode.read(file, "rubric")
            node.allowOnly("name", "checks", "mistakes")
            val rubric = Rubric(node.get("name").text(), rules(node.get("checks")), costs(node.find("mistakes")), fingerprint(file))
            if (rubric.total <= 0) node.fail("all checks have 0 points: give at least one of them some.")
            return rubric
        }

        private fun rules(node: JsonNode): Map<Check, CheckRule> {
            node.allowOnly(*Check.entries.map { it.id }.toTypedArray())
            return Check.entries.associateWith { check ->
                rule(node.find(check.id) ?: node.fail("\"${check.id}\" is missing: add it, with 0 points if it does not count."))
            }
        }

        private fun rule(node: JsonNode): CheckRule {
            node.allowOnly("points", "tolerance", "zero", "why")
            val points = node.get("points").between(MOST_POINTS)
            val tolerance = node.get("tolerance").between(MOST_ERROR)
            val zero = node.find("zero")?.between(MOST_ERROR) ?: tolerance
            if (zero < tolerance) node.fail("\"zero\" ($zero) is below \"tolerance\" ($tolerance): make it at least as large.")
            node.find("why")?.optionalText()
            return CheckRule(points, tolerance, zero)
        }

        private fun costs(node: JsonNode?): Map<Mistake, Double> {
            if (node == null) return emptyMap()
            node.allowOnly(*Mistake.entries.map { it.id }.toTypedArray())
            return Mistake.entries.mapNotNull { mistake -> node.find(mistake.id)?.let { mistake to it.between(1.0) } }.toMap()
        }

        private fun JsonNode.between(most: Double): Double =
            number("a number from 0 to ${most.toInt()}") { text -> text.toDoubleOrNull()?.takeIf { it in 0.0..most } }

        private fun fingerprint(file: Path): String =
            MessageDigest.getInstance("SHA-256").digest(Home.read(file, "rubric")).joinToString("") { "%02x".format(it) }
    }
}

/**
 * What one check is worth.
 *
 * @param tolerance relative error up to which it earns all of its points.
 * @param zero relative error from which it earns none; in between the points fall in a straight line.
 */
public class CheckRule(
    public val points: Double,
    public val tolerance: Double,
    public val zero: Double,
) {
    /** The share of the points that an [error] leaves, 0 to 1. */
    public fun share(error: Double): Double =
        when {
            error <= tolerance -> 1.0
            error >= zero -> 0.0
            else -> (zero - error) / (zero - tolerance)
        }
}
