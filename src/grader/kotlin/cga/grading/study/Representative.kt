package cga.grading.study

import cga.framework.InputError
import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import org.joml.Matrix4d
import kotlin.math.abs

/** Chooses the draw by which a program is studied. */
internal object Representative {
    /** Of [draws] the one whose model matrix differs most from none: there no two spaces are alike. Later draws come first, state is complete by then. */
    fun of(
        rig: ProbeRig,
        program: ProbeProgram,
        capture: Capture,
        number: Int,
        draws: List<CapturedDraw>,
    ): CapturedDraw {
        // Numbers that grow from picture to picture leave nothing to be seen in the last.
        val latest = draws.asReversed().filter(::isMeasured).ifEmpty { draws.asReversed() }.take(MOST)
        val formula =
            GeometryFormula.of(
                rig,
                program,
                capture.programs[number].attributes.values,
                program.constants + latest.first().uniforms.associate { it.name to it.numbers },
            )
                ?: throw InputError("no vertex attribute moves the vertices")
        return latest.maxBy { draw ->
            val values = draw.uniforms.associate { it.name to it.numbers }
            val model = if (program.matrices.all { it in values }) Spaces.of(formula, program.matrices, values)?.model else null
            if (model == null) 0.0 else (0..11).sumOf { abs(model.get(it / 4, it % 4) - Matrix4d().get(it / 4, it % 4)).coerceAtMost(1.0) }
        }
    }

    /** What [box] is in another object's draw of the same moment: one whose model matrix is another, while the view is the same; null where there is none. */
    fun other(
        capture: Capture,
        number: Int,
        formula: GeometryFormula,
        box: BlackBox,
    ): BlackBox? {
        val model = box.spaces.model ?: return null
        return capture.drawsOf(number).asReversed().asSequence().take(MOST).firstNotNullOfOrNull { draw ->
            val values = box.program.values(draw)
            val spaces = Spaces.of(formula, box.program.matrices.filter { it in values }, values)
            spaces?.takeIf { it.view == box.spaces.view && it.model?.equals(model, APART) == false }?.let { box.drawn(it, values) }
        }
    }

    private fun isMeasured(draw: CapturedDraw) = draw.uniforms.all { uniform -> uniform.numbers.all { abs(it) < LARGEST } }

    private const val MOST = 200

    /** Brighter than any light of which a picture shows more than white. */
    private const val LARGEST = 1e6
    private const val APART = 0.1
}
