package cga.grading.reading

import cga.reader.shader.Operation
import cga.reader.shader.Source
import java.util.BitSet

/** Finds the terms that the picture is the sum of. */
internal class TermFinder(private val samples: Samples, private val factors: FactorFinder) {
    /** Keys of what more than one channel is made of. */
    private val shared = HashSet<Long>()

    /** The terms of [sums], which are those of the three channels of each run. */
    fun of(sums: List<List<List<Node>>>): List<Term> {
        for (channels in sums) shared += common(channels)
        val expansion = Expansion({ it.key in shared }, { factors.of(it) != null })
        val found = List(ShaderPair.CHANNELS) { LinkedHashMap<List<Part>, Monomial>() }
        val runs = HashMap<List<Part>, BitSet>()
        for ((run, channels) in sums.withIndex()) {
            for ((channel, nodes) in channels.withIndex()) {
                for ((key, same) in nodes.flatMap(expansion::of).groupBy { it.key }) {
                    found[channel].putIfAbsent(key, Monomial(same.sumOf { it.sign }, same[0].parts))
                    runs.getOrPut(key, ::BitSet).set(run)
                }
            }
        }
        val all = found[0].values.map { red ->
            term(listOf(red) + found.drop(1).mapNotNull { partner(red, it.values) }, runs.getValue(red.key))
        }
        return withoutFog(all.filterNot(::isNothing).groupBy(::signature).values.map(::merged))
    }

    /** Sums begin with 0. */
    private fun isNothing(term: Term) = term.factors.any { it is Factor.Scale && it.node.source is Source.Constant && it.node.value == 0.0 }

    /** [terms] without the factors that all of them have: fog lies over everything. */
    private fun withoutFog(terms: List<Term>): List<Term> {
        val textured = terms.filter { it.textures.isNotEmpty() }
        if (textured.size < 2) return terms

        fun veils(term: Term) = term.factors.filter { it is Factor.Unknown || it is Factor.Fade }.map { it.node.key }.toSet()
        val fog = textured.map(::veils).reduce(Set<Long>::intersect)
        return if (fog.isEmpty()) {
            terms
        } else {
            terms.map { term ->
                Term(term.textures, term.colors, term.factors.filter { it.node.key !in fog }, term.sign, term.runs)
            }
        }
    }

    /** What a term is but for constant factors. */
    private fun signature(term: Term): Any =
        listOf(
            term.textures,
            term.colors.map { it[0].key },
            term.factors.filter { it !is Factor.Scale }.map { it.line to it.node.key }.toSet(),
        )

    /** One term of [same], which differ in constant factors only: where something is mixed, both shares of it. */
    private fun merged(same: List<Term>): Term {
        val first = same[0]
        if (same.size == 1) return first

        fun scale(term: Term) =
            term.sign * term.factors.filterIsInstance<Factor.Scale>().fold(1.0) { product, it -> product * it.node.value }
        val own = scale(first) / first.sign
        if (own == 0.0) return merged(same.drop(1))
        return Term(first.textures, first.colors, first.factors, same.sumOf(::scale) / own, first.runs)
    }

    /** The monomial of another channel that is like [red]: the same where both share, the same place where not. */
    private fun partner(red: Monomial, others: Collection<Monomial>): Monomial? {
        val own = shape(red)
        return others.find { shape(it) == own }
    }

    private fun shape(monomial: Monomial): List<Any> =
        monomial.parts
            .map { (node, power) ->
                (
                    if (node.key in shared &&
                        node.source !is Source.Constant
                    ) {
                        node.key
                    } else {
                        kind(node)
                    }
                ) to power
            }.sortedBy { it.toString() }

    /** What a node of one channel is, whichever that is. */
    private fun kind(node: Node): Any =
        when (val source = node.source) {
            is Source.Uniform -> "uniform ${source.slot.name}"
            is Source.Input -> "input ${source.slot.name}"
            is Source.Constant -> "constant"
            null -> "${node.operation} ${node.line} ${textureOf(node)?.sampler}"
            else -> "unset"
        }

    private fun common(channels: List<List<Node>>): Set<Long> {
        val sets = channels.map(::reachable)
        return sets[0].intersect(sets[1]) + sets[0].intersect(sets[2]) + sets[1].intersect(sets[2])
    }

    private fun reachable(from: List<Node>): Set<Long> {
        val seen = HashSet<Long>()
        val open = ArrayDeque(from)
        while (open.isNotEmpty()) {
            val node = open.removeLast()
            if (seen.add(node.key)) open += node.operands
        }
        return seen
    }

    private fun term(channels: List<Monomial>, runs: BitSet): Term {
        val red = channels[0]
        val textures = ArrayList<Texel>()
        val colors = ArrayList<List<Node>>()
        val common = ArrayList<Factor>()
        for ((i, part) in red.parts.withIndex()) {
            val (node, power) = part
            val same = listOf(node) + channels.drop(1).mapNotNull { counterpart(it, i, red) }
            // A constant is a colour where it differs from channel to channel.
            val isColor = if (node.source is Source.Constant) same.any { it.value != node.value } else node.key !in shared
            val texel = textureOf(node)
            when {
                texel != null -> textures += texel
                isColor -> colors += same
                else -> common += factor(node, power)
            }
        }
        return Term(textures, colors, common, red.sign, runs)
    }

    /** The part of another channel's monomial that is what part [i] is of [red]. */
    private fun counterpart(other: Monomial, i: Int, red: Monomial): Node? {
        val node = red.parts[i].first
        val own = other.parts.getOrNull(i)?.first
        val isLike = own != null && other.parts.size == red.parts.size && (own.key == node.key || kind(own) == kind(node))
        return if (isLike) own else other.parts.map { it.first }.find { it.key !in shared && kind(it) == kind(node) }
    }

    private fun factor(node: Node, power: Int): Factor {
        val known = factors.of(node)
        if (power == 1) return known ?: if (node.operation == null) Factor.Scale(node) else Factor.Unknown(node)
        // A denominator that is the sum of attenuation is what one divides by.
        if (known is Factor.Fade && !known.isDivided) return Factor.Fade(known.way, known.k, true, node, true)
        return if (known is Factor.Scale || node.operation == null) Factor.Scale(node) else Factor.Unknown(node)
    }

    /** The texture that [node] is a component of, perhaps to a power. */
    private fun textureOf(node: Node): Texel? =
        when (node.operation) {
            Operation.TEXTURE -> (node.operands[0].source as? Source.Uniform)?.let { Texel(it.slot.name, 1.0) }
            Operation.POW -> textureOf(node.operands[0])?.let { Texel(it.sampler, it.power * node.operands[1].value) }
            else -> null
        }
}
