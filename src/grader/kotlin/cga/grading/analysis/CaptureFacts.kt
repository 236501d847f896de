package cga.grading.analysis

import cga.grading.capture.Capture
import cga.grading.capture.CapturedDraw
import cga.grading.scene.ProgramFacts
import cga.grading.study.ShaderStudy
import cga.grading.substitute.Substitutes
import org.lwjgl.opengl.GL33C.GL_BOOL
import org.lwjgl.opengl.GL33C.GL_INT
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D
import org.lwjgl.opengl.GL33C.GL_SAMPLER_CUBE

/** What a capture tells of its programs without running them. */
internal class CaptureFacts(private val capture: Capture) {
    private val draws = capture.draws

    /** Names of the active uniforms. */
    val uniforms: Set<String> = draws.flatMap { it.uniforms }.map { it.name }.toSet()

    /** For the scene judge, with what [study] found out. */
    fun program(
        study: ShaderStudy,
        substitutes: Substitutes,
    ): ProgramFacts =
        ProgramFacts(
            unset = unset { it !in WHOLE },
            idle = unset { it == GL_INT || it == GL_BOOL },
            declares = UniformDeclarations(capture.programs.flatMap { listOf(it.vertexSource, it.fragmentSource) }, uniforms)::declares,
            drawn = capture.frames.filter { frame -> frame.steps.any { it is CapturedDraw } }.map { it.moment }.toSet(),
            isReplaced = draws.isNotEmpty() && draws.all { capture.programs[it.program].substituted },
            isRead = substitutes.isRead,
            isReadWhole = substitutes.isWhole,
            canCone = study.canCone,
            deadly = study.deadly,
            lent = study.lent,
            strange = study.strange,
        )

    /** Names of the uniforms [ofType] that are 0 in every draw. */
    private fun unset(ofType: (Int) -> Boolean): Set<String> {
        val numbers = draws.flatMap { it.uniforms }.filter { ofType(it.type) }
        val set = numbers.filter { uniform -> uniform.numbers.any { it != 0f } }.map { it.name }.toSet()
        return numbers.map { it.name }.toSet() - set
    }

    private companion object {
        /** Numbers for which 0 is as good as any. */
        val WHOLE = setOf(GL_SAMPLER_2D, GL_SAMPLER_CUBE, GL_INT, GL_BOOL)
    }
}
