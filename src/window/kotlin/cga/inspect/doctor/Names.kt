package cga.inspect.doctor

/** Causes that lie in the names of uniforms: what the shaders use and nobody sends, and what is sent and nobody knows. */
internal object Names {
    /**
     * One cause for each name that the program and the shaders write differently, or that the shaders use and nobody sends, whatever number of
     * lights and members has it; then what was said of other names that no shader has.
     */
    fun mismatches(evidence: Evidence): List<Finding> {
        val unbound = lightsNeverSent(evidence).toSet()
        val missing = missing(evidence).filter { it !in unbound }
        val pairs = pairs(missing.map(::plain).distinct(), evidence)
        // A normal matrix that is not sent under another name either is a cause of its own.
        val groups = missing.filter { plain(it) in pairs || "normal" !in it }.groupBy { slip(plain(it), pairs[plain(it)]) }
        // What is told from the shader's side need not be told from the program's again.
        val said = evidence.warnings.distinctBy(::plain).filter { warning -> pairs.values.none { it in plain(warning) } }
        return groups.map { (slip, names) -> finding(names, slip.second) } +
            said.map { Finding(it.removePrefix("warning: ").replaceFirstChar(Char::uppercase), CURE) }
    }

    /** What is written differently: the names of two structs where their members are the same. */
    private fun slip(
        used: String,
        sent: String?,
    ): Pair<String, String?> {
        val isStruct = sent == null || used.substringAfter('.') == sent.substringAfter('.')
        return if (isStruct) used.substringBefore('.') to sent?.substringBefore('.') else used to sent
    }

    private fun finding(
        names: List<String>,
        sent: String?,
    ): Finding {
        val others = if (names.size > 1) " and ${names.size - 1} more of it" else ""
        val hint = if (sent == null) "" else " The nearest name that is sent is $sent."
        return Finding("The shader uses ${names.first()}$others, which nobody sends: it is 0.$hint", CURE)
    }

    /** For each of the [missing] names the one that is sent in its place: rather one that the program in use does not know. */
    private fun pairs(
        missing: List<String>,
        evidence: Evidence,
    ): Map<String, String> {
        val active = evidence.uniforms.map { plain(it.name) }.toSet()
        val (known, unknown) = evidence.sent.map(::plain).distinct().partition { it in active }
        val pairs = LinkedHashMap<String, String>()
        for (name in missing) {
            val sent = nearest(name, unknown - pairs.values.toSet(), LOOSE) ?: nearest(name, known, CLOSE) ?: continue
            pairs[name] = sent
        }
        return pairs
    }

    private fun nearest(
        name: String,
        others: List<String>,
        limit: Double,
    ): String? = others.minByOrNull { Likeness.distance(name, it) }?.takeIf { Likeness.distance(name, it) <= limit }

    /** The uniforms of lights that are used, where nothing of any light is sent. */
    fun lightsNeverSent(evidence: Evidence): List<String> =
        if (evidence.sent.any(::isOfLight)) emptyList() else missing(evidence).filter(::isOfLight)

    private fun missing(evidence: Evidence) =
        evidence.uniforms.map { it.name }.filter { it !in evidence.sent && it.removeSuffix("[0]") !in evidence.sent }

    private fun isOfLight(name: String) = "light" in name.lowercase()

    private fun plain(name: String) = name.replace(Regex("""\[\d+]"""), "")

    private const val CURE = "Give it one name in the Kotlin code and in both shaders, to the letter."

    /** A name that is sent and has no use is a likely slip; one that has a use of its own must be nearly the same. */
    private const val LOOSE = 0.5
    private const val CLOSE = 1.0 / 3
}
