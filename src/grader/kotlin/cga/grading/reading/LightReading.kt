package cga.grading.reading

import cga.reader.shader.Source

/**
 * A light of a program: the terms that have its colour, or that speak of its place.
 *
 * @property name of the uniform of its colour; where it has none, of what stands for it.
 * @property color red, green and blue; null where it has no colour of its own.
 * @property way from the surface to where it is.
 */
internal class LightReading(
    val name: String,
    val color: List<Node>?,
    val way: ToPoint,
    val terms: List<Term>,
) {
    val diffuse: List<Term> = terms.filter { term -> term.factors.none { it is Factor.Highlight } && term.factors.any { it is Factor.Cosine } }
    val specular: List<Term> = terms.filter { term -> term.factors.any { it is Factor.Highlight } }
    val cone: Factor.Cone? = terms.firstNotNullOfOrNull { term -> term.factors.firstNotNullOfOrNull { it as? Factor.Cone } }
    val fade: Factor.Fade? = terms.firstNotNullOfOrNull { term -> term.factors.firstNotNullOfOrNull { it as? Factor.Fade } }
}

/** Groups the terms of a program by light. */
internal class LightFinder(private val reading: ProgramReading) {
    private val lit = reading.terms.filter { it.ways.isNotEmpty() }

    /** Colours that are in every lit term are of the object, not of a light. */
    val common: Set<Int> = lit.map { term -> term.colors.map { it[0].key }.toSet() }.reduceOrNull(Set<Int>::intersect).orEmpty()
        .takeIf { lit.map { mainWay(it) }.distinctBy(::placeOf).size > 1 }.orEmpty()

    fun find(): List<LightReading> {
        val byColor = lit.groupBy { term -> colorOf(term)?.get(0)?.key }
        val wayCounts = byColor.mapValues { (_, terms) -> terms.groupBy { placeOf(mainWay(it)) } }
        return byColor.flatMap { (key, terms) -> split(key, terms, wayCounts) }
    }

    private fun split(key: Int?, terms: List<Term>, all: Map<Int?, Map<Any, List<Term>>>): List<LightReading> {
        val own = all.getValue(key)
        val elsewhere = all.filterKeys { it != key }.values.flatMap { it.keys }.toSet()
        val exclusive = own.keys - elsewhere
        if (key != null && (own.size == 1 || exclusive.size <= 1)) {
            val place = exclusive.singleOrNull() ?: own.maxBy { it.value.size }.key
            return listOf(light(terms, place))
        }
        return own.keys.map { place -> light(own.getValue(place), place) }
    }

    private fun light(terms: List<Term>, place: Any): LightReading {
        val color = colorOf(terms[0])
        val way = terms.flatMap { it.ways }.find { placeOf(it) == place } ?: terms[0].ways[0]
        return LightReading(nameOf(color), color, way, terms)
    }

    private fun mainWay(term: Term): ToPoint =
        term.factors.firstNotNullOfOrNull { (it as? Factor.Cosine)?.light?.way ?: (it as? Factor.Highlight)?.light?.way } ?: term.ways[0]

    /** The colour that is no texture's and not in everything. */
    private fun colorOf(term: Term): List<Node>? = term.colors.filter { it[0].key !in common }.minByOrNull { if (it[0].source is Source.Uniform) 0 else 1 }

    private fun nameOf(color: List<Node>?): String =
        when (val source = color?.get(0)?.source) {
            is Source.Uniform -> source.slot.name
            is Source.Input -> source.slot.name
            is Source.Constant -> "line ${color[0].line.line}"
            else -> color?.get(0)?.let { "line ${it.line.line}" } ?: "light"
        }

    private fun placeOf(way: ToPoint): Any =
        listOf(way.space) + listOf(way.place.x(), way.place.y(), way.place.z()).map { Math.round(it * 1e6) }
}
