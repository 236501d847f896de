package cga.grading.reading

import cga.reader.shader.Operation

/** A number in a product; [power] is −1 in a denominator. */
internal data class Part(val key: Long, val power: Int)

/** A summand of a channel: [sign] times the product of its parts. As often as it is there, so large is [sign]. */
internal class Monomial(val sign: Double, val parts: List<Pair<Node, Int>>) {
    val key: List<Part> = parts.map { (node, power) -> Part(node.key, power) }.sortedBy { it.key * 2 + it.power }

    fun times(other: Monomial) = Monomial(sign * other.sign, parts + other.parts)
}

/**
 * A channel of the picture as a sum of products: sums are taken apart, products distributed over them, down to what [isWhole] or is made in no such way.
 *
 * Where the shader limits a colour, or chooses one of two, the one that was taken counts.
 */
internal class Expansion(private val isShared: (Node) -> Boolean, private val isWhole: (Node) -> Boolean) {
    fun of(node: Node): List<Monomial> {
        val operation = node.operation ?: return one(node)
        if (operation == Operation.TEXTURE || (isShared(node) && isWhole(node))) return one(node)
        return when (operation) {
            Operation.ADD -> limited(of(node.operands[0]) + of(node.operands[1]), node)
            Operation.SUB -> limited(of(node.operands[0]) + of(node.operands[1]).map { Monomial(-it.sign, it.parts) }, node)
            Operation.NEG -> of(node.operands[0]).map { Monomial(-it.sign, it.parts) }
            Operation.MUL -> product(node)
            Operation.DIV -> of(node.operands[0]).map { Monomial(it.sign, it.parts + (node.operands[1] to -1)) }
            Operation.SELECT -> of(node.operands[if (node.operands[0].value != 0.0) 1 else 2])
            Operation.MIN, Operation.MAX -> if (isShared(node)) {
                one(node)
            } else {
                of(
                    node.operands.first {
                        it.value == node.value ||
                            it === node.operands[1]
                    },
                )
            }
            else -> one(node)
        }
    }

    private fun product(node: Node): List<Monomial> {
        val left = of(node.operands[0])
        val right = of(node.operands[1])
        if (left.size.toLong() * right.size > MOST) return one(node)
        return left.flatMap { a -> right.map { a.times(it) } }
    }

    private fun limited(sum: List<Monomial>, node: Node) = if (sum.size > MOST) one(node) else sum

    private fun one(node: Node) = listOf(Monomial(1.0, listOf(node to 1)))

    private companion object {
        const val MOST = 4096
    }
}
