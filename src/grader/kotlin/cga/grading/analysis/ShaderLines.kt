package cga.grading.analysis

import cga.grading.capture.Capture
import cga.grading.findings.Found
import cga.grading.findings.Mistake
import cga.grading.findings.Place
import cga.grading.reading.CaptureReading
import cga.grading.reading.ShaderLine
import cga.grading.sheet4.shading.Deviation
import cga.grading.sheet4.shading.Shading
import cga.reader.shader.Stage

/** Where in the shaders of [capture] mistakes are made. Needs no context. */
internal class ShaderLines(private val capture: Capture) {
    private val deviations: List<Pair<Int, Deviation>> =
        Shading(CaptureReading(capture)).byProgram.flatMap { (program, all) -> all.map { program to it } }

    /** [found] with the line of the shader that makes it; as it is where that has a place already, or none is known. */
    fun located(found: Found): Found {
        if (found.places.isNotEmpty() || found.mistake == Mistake.UNKNOWN) return found
        val lines = deviations
            .filter { (_, it) ->
                it.mistake == found.mistake
            }.mapNotNull { (program, it) -> it.line?.let { line -> place(program, line) } }
        val place = lines.firstOrNull() ?: return found
        return with(found) { Found(mistake, fit, difference, where, alternatives, explains, details, listOf(place), proof) }
    }

    private fun place(program: Int, line: ShaderLine): Place? {
        if (line.line == 0) return null
        val captured = capture.programs[program]
        val isVertex = line.stage == Stage.VERTEX
        val source = if (isVertex) captured.vertexSource else captured.fragmentSource
        val file = if (isVertex) captured.vertexFile else captured.fragmentFile
        return Place(file ?: "${line.stage.name.lowercase()} shader", line.line).within(source)
    }
}
