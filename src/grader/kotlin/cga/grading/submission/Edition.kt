package cga.grading.submission

import cga.framework.InputError
import java.util.Properties

/**
 * An edition of the course's sheet: what differs from year to year, read from a profile file beside this class.
 *
 * @param gamma the exponent that colours are decoded and encoded with; 1 where the sheet asks for none.
 * @param attenuation `table` (K_c + K_l·d + K_q·d², Table 1) or `inverse-square` (1/d²).
 * @param pointBind the arguments of a point light's `bind`, likewise [spotBind].
 */
public class Edition private constructor(
    public val id: String,
    properties: Properties,
) {
    public val title: String = properties.getValue("title")
    public val gamma: Double = properties.getValue("gamma").toDouble()
    public val attenuation: String = properties.getValue("attenuation")
    public val transformations: List<String> = properties.getValue("transformations").split(',').map(String::trim)
    public val pointBind: String = properties.getValue("bind.point")
    public val spotBind: String = properties.getValue("bind.spot")

    /** What in a source speaks for this edition, each with what it is called. */
    private val evidence: Map<String, Regex> =
        properties
            .stringPropertyNames()
            .filter { it.startsWith(EVIDENCE) }
            .sorted()
            .associate { it.removePrefix(EVIDENCE) to Regex(properties.getValue(it)) }

    private fun evidenceIn(sources: List<SourceFile>): List<String> =
        evidence.mapNotNull { (what, pattern) -> sources.firstOrNull { pattern.containsMatchIn(it.text) }?.let { "$what in ${it.name}" } }

    /** The editions that there are. */
    public companion object {
        private const val EVIDENCE = "evidence."

        /** The sheet's own first. */
        public val ALL: List<Edition> by lazy {
            val list = resource("editions.properties") ?: error("the list of editions is missing from the program")
            list.getValue("editions").split(',').map { id ->
                Edition(
                    id.trim(),
                    resource("edition-${id.trim()}.properties") ?: error("the profile of edition $id is missing from the program"),
                )
            }
        }

        /** The edition called [id]. Throws [InputError] where there is none. */
        public fun named(id: String): Edition =
            ALL.firstOrNull { it.id == id } ?: throw InputError("there is no edition $id: choose one of ${ALL.joinToString { it.id }}.")

        /** The edition that most in [sources] speaks for; the sheet's own where nothing does. */
        public fun detect(sources: List<SourceFile>): DetectedEdition =
            ALL.map { DetectedEdition(it, it.evidenceIn(sources)) }.maxBy { it.evidence.size }

        private fun resource(name: String): Properties? =
            Edition::class.java.getResourceAsStream(name)?.use { stream -> Properties().apply { load(stream.reader()) } }

        private fun Properties.getValue(key: String) = getProperty(key) ?: error("an edition's profile lacks $key")
    }
}

/** An edition and what speaks for it: where in the sources it shows, or that it was asked for. */
public class DetectedEdition(
    public val edition: Edition,
    public val evidence: List<String>,
)
