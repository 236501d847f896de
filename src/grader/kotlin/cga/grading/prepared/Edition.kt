package cga.grading.prepared

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

    /** What in a source speaks for this edition, as regular expressions, each with what it is called. Only jobs look for it. */
    internal val evidence: Map<String, String> =
        properties.stringPropertyNames().filter { it.startsWith(EVIDENCE) }.sorted().associate {
            it.removePrefix(EVIDENCE) to properties.getValue(it)
        }

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

        private fun resource(name: String): Properties? =
            Edition::class.java.getResourceAsStream(name)?.use { stream -> Properties().apply { load(stream.reader()) } }

        private fun Properties.getValue(key: String) = getProperty(key) ?: error("an edition's profile lacks $key")
    }
}
