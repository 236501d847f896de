package cga.grading.reading

import cga.reader.shader.Source

/**
 * A light of a program: the terms that have its colour, or that speak of its place.
 *
 * @property name of the uniform of its colour; where it has none, of what stands for it.
 * @property color red, green and blue; null where it has no colour of its own.
 * @property way from the surface to where it is.
 * @property sharesColor whether it has the colour of a light before it.
 * @property gate where a branch lets it shine at all.
 */
internal class LightReading(
    val name: String,
    val color: List<Node>?,
    val way: ToPoint,
    val terms: List<Term>,
    specularSamplers: Set<String>,
    val sharesColor: Boolean,
    val gate: Factor.Cone?,
) {
    private val isSpecular = terms.associateWith { term ->
        term.factors.any { it is Factor.Highlight } ||
            (term.factors.any { it is Factor.Unknown } && term.textures.any { it.sampler in specularSamplers })
    }
    val specular: List<Term> = terms.filter(isSpecular::getValue)
    val diffuse: List<Term> = (terms - specular.toSet()).filter { term -> term.factors.any { it is Factor.Cosine } }
    val cone: Factor.Cone? = terms.firstNotNullOfOrNull { term -> term.factors.firstNotNullOfOrNull { it as? Factor.Cone } } ?: gate

    /** −1 where the vector to the light leads away from it. */
    val sign: Double get() = diffuse
        .firstNotNullOfOrNull { term ->
            term.factors.firstNotNullOfOrNull { it as? Factor.Cosine }
        }?.light
        ?.sign
        ?: 1.0
    val fade: Factor.Fade? = terms.firstNotNullOfOrNull { term -> term.factors.firstNotNullOfOrNull { it as? Factor.Fade } }
}

/** Groups the terms of a program by light. */
internal class LightFinder(private val reading: ProgramReading) {
    private val lit = reading.terms.filter { it.ways.isNotEmpty() }

    /** Colours that are in every term, lit or not, are of the object and not of a light. */
    val common: Set<Long> = reading.terms
        .filter { it.textures.isNotEmpty() }
        .map { term -> term.colors.map { it[0].key }.toSet() }
        .reduceOrNull(Set<Long>::intersect)
        .orEmpty()
        .takeIf { lit.isNotEmpty() && lit.size < reading.terms.size }
        .orEmpty()

    fun find(): List<LightReading> {
        val byColor = lit.groupBy { term -> colorOf(term)?.get(0)?.key }
        return byColor.flatMap { (key, terms) -> split(key, terms, (byColor - key).values.flatten()) }
    }

    /** The lights of [terms], which have one colour: one, unless several places have no other. */
    private fun split(key: Long?, terms: List<Term>, others: List<Term>): List<LightReading> {
        val main = terms.groupBy { placeOf(mainWay(it)) }
        val elsewhere = others.map { placeOf(mainWay(it)) }.toSet()
        val exclusive = (main.keys - elsewhere).ifEmpty { terms.flatMap { it.ways }.map(::placeOf).toSet() - elsewhere }
        if (key != null && (main.size == 1 || exclusive.size <= 1)) {
            return listOf(light(terms, exclusive.singleOrNull() ?: main.maxBy { it.value.size }.key, 0))
        }
        return main.keys.mapIndexed { i, place -> light(main.getValue(place), place, i) }
    }

    /** Light number [number] of those that have one colour. */
    private fun light(terms: List<Term>, place: Any, number: Int): LightReading {
        val color = colorOf(terms[0])
        val way = terms.flatMap { it.ways }.find { placeOf(it) == place } ?: terms[0].ways[0]
        val name = nameOf(color) + if (number == 0) "" else " (${number + 1})"
        val gate = if (terms.any { term -> term.factors.any { it is Factor.Cone } }) null else reading.gates.of(way, terms)
        return LightReading(name, color, way, terms, specularSamplers, color != null && number > 0, gate)
    }

    /** What lit terms read that no plain cosine is multiplied with. */
    private val specularSamplers: Set<String> =
        lit.flatMap(::samplers).toSet() -
            lit
                .filter { term ->
                    term.factors.none { it is Factor.Highlight || it is Factor.Unknown } &&
                        term.factors.any { it is Factor.Cosine }
                }.flatMap(::samplers)
                .toSet()

    private fun samplers(term: Term) = term.textures.map { it.sampler }

    private fun mainWay(term: Term): ToPoint =
        term.factors.firstNotNullOfOrNull { (it as? Factor.Cosine)?.light?.way ?: (it as? Factor.Highlight)?.light?.way } ?: term.ways[0]

    /** The colour that is no texture's and not in everything. */
    private fun colorOf(
        term: Term,
    ): List<Node>? = term.colors.filter { it[0].key !in common }.minByOrNull { if (it[0].source is Source.Uniform) 0 else 1 }

    private fun nameOf(color: List<Node>?): String =
        when (val source = color?.get(0)?.source) {
            is Source.Uniform -> source.slot.name
            is Source.Input -> source.slot.name
            is Source.Constant -> "line ${color[0].line.line}"
            else -> color?.get(0)?.let { "line ${it.line.line}" } ?: "light"
        }

    private fun placeOf(way: ToPoint): Any = way.inView(reading.spaces).let { listOf(it.x, it.y, it.z) }.map { Math.round(it * 1e5) }
}
