package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D

/** What a capture tells of the textures that the samplers of a program read. */
internal object SamplerFacts {
    /** Names of the files that each sampler of program [number] reads, as far as known, over all draws. */
    fun files(
        capture: Capture,
        number: Int,
    ): Map<String, Set<String>> {
        val names = files(capture).toMap()
        val read = read(capture, number).map { (sampler, texture) -> sampler to texture?.let(names::get) }
        return read.groupBy({ it.first }, { it.second }).mapValues { it.value.filterNotNull().toSet() }.filterValues { it.isNotEmpty() }
    }

    /** Names of all files that are there to be read. */
    fun there(capture: Capture): Set<String> = files(capture).map { it.second }.toSet()

    /** Numbers of textures and the names of their files; no number where no draw reads a texture of that file. */
    private fun files(capture: Capture): List<Pair<Int?, String>> =
        capture.events
            .filter { it.kind == EventKind.TEXTURE_FILE }
            .map { it.text.substringBefore(' ').toIntOrNull() to it.text.substringAfter(' ') }

    /**
     * The samplers of program [number] that find no texture at their unit in any draw: OpenGL gives black. None where textures may have
     * been left out of the capture.
     */
    fun unbound(
        capture: Capture,
        number: Int,
    ): Set<String> {
        if (capture.events.any { it.kind == EventKind.NOT_CAPTURED }) return emptySet()
        val read = read(capture, number).groupBy({ it.first }, { it.second }).filterValues { all -> all.all { it == null } }.keys
        // Where nothing has a texture at all, none was loaded, and units have nothing to do with it.
        return if (capture.textures.isEmpty()) emptySet() else read
    }

    /** Each sampler of each draw with the number of its texture. */
    private fun read(
        capture: Capture,
        number: Int,
    ): List<Pair<String, Int?>> =
        capture.frames.flatMap { it.steps }.filterIsInstance<CapturedDraw>().filter { it.program == number }.flatMap { draw ->
            draw.uniforms.filter { it.type == GL_SAMPLER_2D }.map { it.name to draw.textures[it.numbers[0].toInt()] }
        }
}
