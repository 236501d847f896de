package cga.grading.reading

import cga.reader.shader.Operation

/**
 * How the sum of the terms becomes the colour: raised to [power] at the end, 1 where it is not.
 *
 * @property isPartial whether something is added after that.
 */
internal class Encoding(val power: Double, val isPartial: Boolean, val line: ShaderLine?) {
    /** The encoding, and for each run and channel the sums that make the colour. */
    class Found(val encoding: Encoding, val sums: List<List<List<Node>>>)

    private class Step(val inner: Node, val power: Double, val beside: Node? = null)

    companion object {
        fun of(samples: Samples): Found {
            var first = Encoding(1.0, false, null)
            val sums = samples.traces.mapIndexed { i, trace ->
                trace.color.mapIndexed { channel, color ->
                    val parts = ArrayList<Node>()
                    var encoding = Encoding(1.0, false, null)
                    var node = color
                    while (true) {
                        val step = step(node, samples) ?: break
                        step.beside?.let { parts += it }
                        encoding =
                            Encoding(
                                encoding.power * step.power,
                                encoding.isPartial || step.beside != null,
                                if (step.power ==
                                    1.0
                                ) {
                                    encoding.line
                                } else {
                                    node.line
                                },
                            )
                        node = step.inner
                    }
                    if (i == 0 && channel == 0) first = encoding
                    parts + node
                }
            }
            return Found(first, sums)
        }

        private fun step(node: Node, samples: Samples): Step? =
            when (node.operation) {
                Operation.POW -> Step(node.operands[0], node.operands[1].value).takeIf {
                    isSum(node.operands[0]) &&
                        isSame(node.operands[1], samples)
                }
                Operation.SQRT -> Step(node.operands[0], 0.5).takeIf { isSum(node.operands[0]) }
                Operation.MIN, Operation.MAX -> taken(node)?.let { Step(it, 1.0) }
                Operation.ADD -> beside(node.operands[0], node.operands[1], samples) ?: beside(node.operands[1], node.operands[0], samples)
                else -> null
            }

        /** [encoded] with [other] added to it. */
        private fun beside(encoded: Node, other: Node, samples: Samples): Step? =
            if (encoded.operation == Operation.POW ||
                encoded.operation == Operation.SQRT
            ) {
                step(encoded, samples)?.let { Step(encoded, 1.0, other) }
            } else {
                null
            }

        private fun taken(node: Node): Node? = node.operands.find { it.value == node.value && it.operation != null }

        private fun isSame(node: Node, samples: Samples) = samples.values(node).filter { !it.isNaN() }.distinct().size == 1

        /** What is encoded is more than a texture's colour, which is decoded so. */
        private fun isSum(node: Node): Boolean = node.operation != null && node.operation != Operation.TEXTURE
    }
}
