package cga.reader.lower

import cga.reader.spirv.Block
import cga.reader.spirv.Function
import cga.reader.spirv.Op

/** Which block's branch decides whether a block of [function] runs: the nearest one, by label; none for what always runs. */
internal fun guards(function: Function): Map<Int, Int> {
    val blocks = function.blocks.associateBy { it.label }
    val loops = function.blocks.mapNotNull { block ->
        val merge = block.instructions.find { it.op == Op.LOOP_MERGE } ?: return@mapNotNull null
        val ends = setOf(block.label, merge.operands[0])
        ends + merge.operands[1] to reachable(successors(block), blocks, ends) + block.label
    }
    val regions = function.blocks.mapNotNull { block ->
        val end = block.instructions.last()
        if (end.op != Op.BRANCH_CONDITIONAL && end.op != Op.SWITCH) return@mapNotNull null
        val merges = block.instructions.filter { it.op == Op.SELECTION_MERGE }.map { it.operands[0] }
        val stops = loops.filter { block.label in it.second }.flatMap { it.first } + merges + block.label
        block.label to reachable(successors(block), blocks, stops.toSet())
    }
    // Inner ones are smaller, and come after those around them.
    return buildMap { for ((header, region) in regions.sortedByDescending { it.second.size }) for (label in region) put(label, header) }
}

/** The labels that a block may go on to. */
internal fun successors(block: Block): List<Int> {
    val end = block.instructions.last()
    return when (end.op) {
        Op.BRANCH -> listOf(end.operands[0])
        Op.BRANCH_CONDITIONAL -> listOf(end.operands[1], end.operands[2])
        Op.SWITCH -> listOf(end.operands[1]) + (3 until end.operands.size step 2).map { end.operands[it] }
        else -> emptyList()
    }
}

private fun reachable(from: List<Int>, blocks: Map<Int, Block>, stops: Set<Int>): Set<Int> {
    val reached = LinkedHashSet<Int>()
    val next = ArrayDeque(from)
    while (next.isNotEmpty()) {
        val label = next.removeFirst()
        if (label in stops || !reached.add(label)) continue
        next += successors(blocks.getValue(label))
    }
    return reached
}
