package cga.grading.reading

import cga.grading.capture.CapturedProgram
import cga.reader.Problem
import cga.reader.Reading
import cga.reader.shader.Shader
import cga.reader.shader.Stage

/** A captured program that cannot be read; [problems] say where and why. */
internal class Unreadable(val problems: List<Problem>) : RuntimeException(problems.joinToString("; "))

/**
 * The two shaders of a captured program, ready to run.
 *
 * @property repairs what had to be written otherwise, since the reader takes less than some drivers.
 */
internal class ShaderPair private constructor(
    val vertex: Shader,
    val fragment: Shader,
    val repairs: List<String>,
) {
    /** What the fragment shader writes for the screen: the output with at least three components, `gl_FragColor` among them. */
    val color = fragment.outputs.firstOrNull { it.size >= CHANNELS && it.columns == 1 && it.name != "gl_FragCoord" }

    companion object {
        const val CHANNELS = 3

        /** Throws [Unreadable]. */
        fun of(program: CapturedProgram): ShaderPair {
            val vertex = read("vertex shader", program.vertexSource, Stage.VERTEX)
            val fragment = read("fragment shader", program.fragmentSource, Stage.FRAGMENT)
            return ShaderPair(vertex.shader, fragment.shader, vertex.repairs + fragment.repairs)
        }

        private fun read(name: String, text: String, stage: Stage): Reading.Done =
            when (val reading = Reading.of(name, text, stage)) {
                is Reading.Done -> reading
                is Reading.Failed -> throw Unreadable(reading.problems)
            }
    }
}
