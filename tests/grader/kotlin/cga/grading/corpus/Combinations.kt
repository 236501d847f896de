package cga.grading.corpus

import kotlin.random.Random

/**
 * Chooses combinations of rewrites so that any two that go together are together in one of them: many faults show only where two
 * things meet, few only where three do.
 *
 * @param rewrites in the order in which they are applied.
 */
internal class Combinations(private val rewrites: List<Rewrite>) {
    private val byName = rewrites.associateBy { it.name }
    private val order = rewrites.withIndex().associate { (i, rewrite) -> rewrite.name to i }

    /** Every two that go together, each pair in the order of application. */
    val pairs: Set<Pair<String, String>> =
        rewrites
            .flatMap { a -> rewrites.filter { b -> order.getValue(a.name) < order.getValue(b.name) }.map { b -> a to b } }
            .filter { (a, b) -> together(closed(listOf(a, b))) }
            .map { (a, b) -> a.name to b.name }
            .toSet()

    /** The pairs in [names]. */
    fun pairsOf(names: List<String>): List<Pair<String, String>> = names.flatMapIndexed { i, a -> names.drop(i + 1).map { a to it } }

    /** Combinations of at most [size] that cover all [pairs]; the same for the same [seed]. */
    fun choose(
        size: Int,
        seed: Int,
    ): List<List<String>> {
        val random = Random(seed)
        val open = LinkedHashSet(pairs)
        val chosen = ArrayList<List<String>>()
        while (open.isNotEmpty()) {
            val best = (1..TRIES).map { grown(open.first(), open, size, random) }.maxBy { names -> pairsOf(names).count { it in open } }
            open -= pairsOf(best).toSet()
            chosen += best
        }
        return chosen
    }

    /** [seed] with whatever rewrites add the most open pairs to it. */
    private fun grown(
        seed: Pair<String, String>,
        open: Set<Pair<String, String>>,
        size: Int,
        random: Random,
    ): List<String> {
        var picked = closed(listOf(byName.getValue(seed.first), byName.getValue(seed.second)))
        for (candidate in rewrites.shuffled(random)) {
            if (picked.size >= size) break
            val more = closed(picked + candidate)
            val gain = pairsOf(more.map { it.name }).count { it in open } - pairsOf(picked.map { it.name }).count { it in open }
            if (gain > 0 && together(more)) picked = more
        }
        return picked.map { it.name }
    }

    /** With all that they need, in order. */
    private fun closed(some: List<Rewrite>): List<Rewrite> =
        (some + some.flatMap { it.with }.map(byName::getValue)).distinct().sortedBy { order.getValue(it.name) }

    private fun together(some: List<Rewrite>): Boolean =
        some.indices.all { i -> (i + 1..<some.size).all { j -> some[i].goesWith(some[j]) } }

    private companion object {
        const val TRIES = 12
    }
}
