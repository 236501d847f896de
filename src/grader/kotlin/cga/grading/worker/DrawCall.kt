package cga.grading.worker

import cga.coach.calls.Call

/**
 * What a draw function was asked for.
 *
 * @param indexType 0 where the vertices are taken in their order.
 * @param first byte offset into the indices, or first vertex.
 */
internal class DrawCall(
    val mode: Int,
    val count: Int,
    val indexType: Int,
    val first: Long,
    val baseVertex: Int = 0,
    val instances: Int = 1,
) {
    companion object {
        /** The draw that [call] is, null for another function. */
        fun of(call: Call): DrawCall? =
            when (call.name) {
                "glDrawArrays" -> arrays(call, 1)
                "glDrawArraysInstanced" -> arrays(call, call.int(3))
                "glDrawElements" -> elements(call, 1)
                "glDrawElementsBaseVertex" -> elements(call, 1, baseVertex = call.int(4))
                "glDrawElementsInstanced" -> elements(call, 1, instances = call.int(4))
                "glDrawElementsInstancedBaseVertex" -> elements(call, 1, instances = call.int(4), baseVertex = call.int(5))
                "glDrawRangeElements" -> elements(call, RANGED)
                "glDrawRangeElementsBaseVertex" -> elements(call, RANGED, baseVertex = call.int(6))
                else -> null
            }

        private const val RANGED = 3

        private fun arrays(
            call: Call,
            instances: Int,
        ) = DrawCall(call.int(0), call.int(2), 0, call.int(1).toLong(), instances = instances)

        private fun elements(
            call: Call,
            at: Int,
            baseVertex: Int = 0,
            instances: Int = 1,
        ) = DrawCall(call.int(0), call.int(at), call.int(at + 1), call.long(at + 2), baseVertex, instances)
    }
}
