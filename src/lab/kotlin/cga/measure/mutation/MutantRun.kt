package cga.measure.mutation

import cga.exercise.game.ScriptedScene
import cga.imaging.Severity
import cga.imaging.tolerance.Tolerance
import cga.measure.golden.GoldenCase

/** What the golden compare says of one mutant, in every case. */
public class MutantResult internal constructor(
    public val mutant: Mutant,
    public val cases: List<CaseFigures>,
) {
    /** In how many cases the defect is visible. */
    public val visibleIn: Int get() = cases.count { it.isVisible }

    /** In how many cases the exact tier fails: any byte differs. */
    public val failsExactIn: Int get() = cases.count { !it.isIdentical }

    /** In how many cases the tolerant tier fails. */
    public val failsTolerantIn: Int get() = cases.count { it.verdict == Severity.FAIL }
}

/**
 * Draws golden cases with defects and compares them with those without, in the OpenGL context that is current.
 *
 * @param tolerance the tier to try besides the exact one.
 */
public class MutantRun(
    private val mutants: List<Mutant>,
    private val cases: List<GoldenCase>,
    private val tolerance: Tolerance,
) {
    private val sound = cases.associateWith { CasePictures.draw(it, it.scene()) }

    /** What the compare says of each mutant in [case]. A mutant that no longer fits its file is an [IllegalStateException]. */
    public fun figures(case: GoldenCase): List<CaseFigures> {
        // Reading models takes longer than drawing them, and most mutants are shaders: those share a scene.
        val shared = case.scene()
        try {
            return mutants.map { MutatedHome.use(it.edits) { figures(it, case, shared) } }
        } finally {
            shared.scene.cleanup()
        }
    }

    /** [figures] of all cases, in their order, by mutant. */
    public fun results(figures: List<List<CaseFigures>> = cases.map(::figures)): List<MutantResult> =
        mutants.mapIndexed { i, mutant -> MutantResult(mutant, figures.map { it[i] }) }

    /** What the compare says of [renderer]'s pictures. Throws [cga.framework.InputError] where it gives none. */
    public fun result(renderer: Renderer): RendererResult {
        val drawn = renderer.draw(cases)
        val figures = cases.mapIndexed { i, case -> CaseFigures.of(case, sound.getValue(case).picture, drawn.pictures[i], tolerance) }
        return RendererResult(renderer, drawn.name, figures)
    }

    private fun figures(
        mutant: Mutant,
        case: GoldenCase,
        shared: ScriptedScene,
    ): CaseFigures {
        val expected = sound.getValue(case)
        val actual =
            when {
                mutant.picture != null -> expected.changed(mutant.picture)
                mutant.isShader -> CasePictures.draw(case, shared.apply { scene.reloadShaders() })
                else -> drawAlone(mutant, case)
            }
        return CaseFigures.of(case, expected.picture, actual.picture, tolerance, expected.visiblyDifferent(actual))
    }

    private fun drawAlone(
        mutant: Mutant,
        case: GoldenCase,
    ): CasePictures {
        val player = case.scene()
        mutant.beforeRender(player.scene)
        try {
            return CasePictures.draw(case, player)
        } finally {
            mutant.afterRender()
            player.scene.cleanup()
        }
    }
}
