package cga.inspect.doctor

import cga.exercise.components.shader.UniformNames

/** Causes that lie in the names of uniforms: what the shaders use and nobody sends, and what is sent and nobody knows. */
internal object Names {
    /** Each name that the shaders use and nobody sends, one for each struct; and what was said of names that no shader has. */
    fun mismatches(evidence: Evidence): List<Finding> {
        val unbound = lightsNeverSent(evidence).toSet()
        val groups = missing(evidence).filter { it !in unbound }.groupBy { plain(it).substringBefore('.') }.values
        // A normal matrix that is not sent under another name either is a cause of its own.
        val nearest = groups.associateWith { nearest(it.first(), evidence) }.filter { (names, sent) ->
            sent != null ||
                "normal" !in names.first()
        }
        // What is told from the shader's side need not be told from the program's again.
        val said = evidence.warnings.filter { warning -> nearest.values.none { it != null && it in plain(warning) } }
        return nearest.map { (names, sent) -> finding(names, sent) } +
            said.map { Finding(it.removePrefix("warning: ").replaceFirstChar(Char::uppercase), CURE) }
    }

    /** The uniforms of lights that are used, where nothing of any light is sent. */
    fun lightsNeverSent(evidence: Evidence): List<String> =
        if (evidence.sent.any(::isOfLight)) emptyList() else missing(evidence).filter(::isOfLight)

    private fun finding(
        names: List<String>,
        sent: String?,
    ): Finding {
        val others = if (names.size > 1) " and ${names.size - 1} more of it" else ""
        val hint = if (sent == null) "" else " The nearest name that is sent is $sent."
        return Finding("The shader uses ${names.first()}$others, which nobody sends: it is 0.$hint", CURE)
    }

    /** The name that [name] is a slip of, among those sent: rather one that the program in use does not know. */
    private fun nearest(
        name: String,
        evidence: Evidence,
    ): String? {
        val active = evidence.uniforms.map { plain(it.name) }.toSet()
        val (known, unknown) = evidence.sent.map(::plain).distinct().partition { it in active }
        return listOf(unknown, known).firstNotNullOfOrNull { names ->
            names.minByOrNull { UniformNames.distance(it, plain(name)) }?.takeIf {
                UniformNames.distance(it, plain(name)) <=
                    name.length / SLIP
            }
        }
    }

    private fun missing(evidence: Evidence) =
        evidence.uniforms.map { it.name }.filter { it !in evidence.sent && it.removeSuffix("[0]") !in evidence.sent }

    private fun isOfLight(name: String) = "light" in name.lowercase()

    private fun plain(name: String) = name.replace(Regex("""\[\d+]"""), "")

    private const val CURE = "Give it one name in the Kotlin code and in both shaders, to the letter."

    /** One letter in so many may be wrong. */
    private const val SLIP = 3
}
