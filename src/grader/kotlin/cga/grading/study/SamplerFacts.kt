package cga.grading.study

import cga.grading.capture.Capture
import cga.grading.capture.EventKind
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D

/**
 * What a capture tells of the textures that the samplers of a program read.
 *
 * @param files names of the files that each sampler reads, as far as known, over all draws; [there] of all that could be read.
 * @param unbound samplers that find no texture at their unit in any draw: OpenGL gives black. None where textures may have been left out
 * of the capture.
 */
internal class SamplerFacts(
    val files: Map<String, Set<String>> = emptyMap(),
    val there: Set<String> = emptySet(),
    val unbound: Set<String> = emptySet(),
) {
    companion object {
        /** What is drawn into others than the window leaves no texture out. */
        private const val FRAMEBUFFER = "framebuffer"

        /** The samplers of program [number] that read depths, in any draw. */
        fun depthMaps(
            capture: Capture,
            number: Int,
        ): Set<String> = if (capture.textures.none { it.depth != 0 }) {
            emptySet()
        } else {
            read(capture, number)
                .filter { (_, texture) ->
                    texture != null && capture.textures[texture].depth != 0
                }.map { it.first }
                .toSet()
        }

        /** Of program [number]. */
        fun of(
            capture: Capture,
            number: Int,
        ): SamplerFacts {
            // No number where no draw reads a texture of that file.
            val names =
                capture.events
                    .filter { it.kind == EventKind.TEXTURE_FILE }
                    .map { it.text.substringBefore(' ').toIntOrNull() to it.text.substringAfter(' ') }
            val read = read(capture, number)
            return SamplerFacts(files(read, names.toMap()), names.map { it.second }.toSet(), unbound(capture, read))
        }

        private fun files(
            read: List<Pair<String, Int?>>,
            names: Map<Int?, String>,
        ): Map<String, Set<String>> {
            val known = read.groupBy({ it.first }, { (_, texture) -> texture?.let(names::get) })
            return known.mapValues { it.value.filterNotNull().toSet() }.filterValues { it.isNotEmpty() }
        }

        private fun unbound(
            capture: Capture,
            read: List<Pair<String, Int?>>,
        ): Set<String> {
            // Where nothing has a texture at all, none was loaded, and units have nothing to do with it.
            val isPart = capture.events.any { it.kind == EventKind.NOT_CAPTURED && FRAMEBUFFER !in it.text }
            if (isPart || capture.textures.isEmpty()) return emptySet()
            return read.groupBy({ it.first }, { it.second }).filterValues { all -> all.all { it == null } }.keys
        }

        /** Each sampler of each draw with the number of its texture. */
        private fun read(
            capture: Capture,
            number: Int,
        ): List<Pair<String, Int?>> =
            capture.drawsOf(number).flatMap { draw ->
                draw.uniforms.filter { it.type == GL_SAMPLER_2D }.map { it.name to draw.textures[it.numbers[0].toInt()] }
            }
    }
}
