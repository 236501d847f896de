package cga.grading.study

import cga.grading.capture.CapturedDraw
import org.joml.Matrix4dc
import org.lwjgl.opengl.GL33C.GL_ONE

/** Passes over one scene that add up in the picture: everything is drawn once for each light, with what it adds to all before. */
internal object LightPasses {
    /**
     * Sorts [draws] of one picture, each with its model matrix, by pass: their indices. What adds nothing to the same thing drawn before is
     * of the first.
     */
    fun of(draws: List<Pair<CapturedDraw, Matrix4dc>>): List<List<Int>> {
        val times = HashMap<List<Any?>, Int>()
        val passes = draws.indices.groupBy { index ->
            val (draw, model) = draws[index]
            val before = times.merge(thing(draw, model), 1, Int::plus) ?: 1
            if (isAdded(draw)) before - 1 else 0
        }
        return passes.toSortedMap().values.toList()
    }

    private fun isAdded(draw: CapturedDraw) =
        draw.state.run { blend && blendSource == GL_ONE && blendDestination == GL_ONE }

    /** What two draws of the same thing at the same place have in common. */
    fun thing(draw: CapturedDraw, model: Matrix4dc): List<Any?> =
        with(draw) { attributes.map { it.buffer to it.offset } + listOf(indices, first, count, baseVertex) } +
            Spaces.rounded(model)
}
