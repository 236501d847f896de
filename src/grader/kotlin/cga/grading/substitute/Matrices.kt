package cga.grading.substitute

import cga.grading.study.ViewProjection
import org.joml.Matrix4d
import kotlin.math.abs

/**
 * Which matrix takes a vertex where, told by the numbers: a view is the same for all that is drawn in a picture and another in the next; a
 * model matrix stays as it is for the ground; a projection divides by the depth. Names break ties.
 *
 * @property view name of the matrix world space → view space; null where none is sent.
 * @property model name of the one model space → world space.
 * @property modelView GLSL for model space → view space; null where only world space is known.
 * @property clip GLSL for model space → clip space.
 * @property used the names that these have.
 */
internal class Matrices private constructor(
    val view: String?,
    val model: String?,
    val modelView: String?,
    val clip: String,
    val used: Set<String>,
) {
    companion object {
        /** The matrices of [sent]; null where no way to the screen can be made out. */
        fun of(sent: Sent): Matrices? {
            val all = sent.matrices.filterNot { UniformName(it).says("norm", "trans") }
            val (flat, deep) = all.partition { name -> sent.everywhere { isAffine(it.matrix(name)) } }
            val (steady, moving) = flat.partition { sent.isSteady(it) }
            val moved = steady.filterNot { UniformName(it).says("inv") || sent.isConstant(it) }
            val view = moved.minByOrNull { if (isView(it)) 0 else 1 } ?: steady.find(::isView)
            val model = moving.find { sent.isStillSomewhere(it) } ?: if (moving.isEmpty()) only(steady - setOfNotNull(view)) else null
            val whole = moving.filter { it != model }.minByOrNull { if (isView(it)) 0 else 1 }
            val modelView = if (view != null && model != null) "$view * $model" else whole
            val (pure, product) = deep.partition { name -> sent.everywhere { isProjection(it.matrix(name)) } }
            val (cameras, objects) = product
                .filter { name -> sent.everywhere { ViewProjection.of(it.matrix(name)) != null } }
                .partition { sent.isSteady(it) }
            val clip =
                when {
                    pure.isNotEmpty() && modelView != null -> "${pure.first()} * $modelView"
                    cameras.isNotEmpty() && model != null -> "${cameras.first()} * $model"
                    objects.isNotEmpty() && (modelView ?: model) != null -> objects.first()
                    else -> return null
                }
            val used = listOfNotNull(clip, modelView, model, view).flatMap { it.split(" * ") }
            return Matrices(view, model, modelView, clip, used.toSet() + (sent.matrices - flat.toSet()))
        }

        /** The model matrix of a program that draws one thing only. */
        private fun only(names: List<String>) = names.minByOrNull { if (UniformName(it).says("model", "world", "obj")) 0 else 1 }

        private fun isView(name: String) = UniformName(name).says("view", "cam", "sicht", "ansicht", "kamera")

        private fun Sent.everywhere(holds: (Sending) -> Boolean) = frames.all { it.all(holds) }

        private fun Sent.isSteady(name: String) =
            frames.all { frame -> frame.all { it.numbers(name).contentEquals(frame[0].numbers(name)) } }

        private fun Sent.isConstant(name: String) = frames.all { it.last().numbers(name).contentEquals(last.numbers(name)) }

        /** Whether something is drawn at the same place in every frame. */
        private fun Sent.isStillSomewhere(name: String): Boolean =
            frames.flatten().groupBy { it.mesh }.values.any { same -> same.all { it.numbers(name).contentEquals(same[0].numbers(name)) } }

        private fun isAffine(m: Matrix4d) = m.m03() == 0.0 && m.m13() == 0.0 && m.m23() == 0.0 && abs(m.m33() - 1) < 1e-6

        /** Whether [m] is a perspective along −z and no more. */
        private fun isProjection(m: Matrix4d): Boolean {
            val others = listOf(m.m01(), m.m02(), m.m03(), m.m10(), m.m12(), m.m13(), m.m30(), m.m31(), m.m33())
            return m.m23() < 0 && others.all { abs(it) < 1e-6 * abs(m.m23()) }
        }
    }
}
