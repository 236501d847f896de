package cga.grading.study

import org.joml.Vector3d
import kotlin.math.PI
import kotlin.math.exp
import kotlin.random.Random

/** Measures one light, step by step: where it is, its distance law, its cone, its highlight. */
internal class LightStudy(
    private val search: LightSearch,
    private val roles: TextureRoles,
) {
    private val random = Random(8)

    /** What the light of [probe] does; null where it shines on nothing that was looked at. */
    fun of(probe: LightProbe): LightModel? {
        val texels = texels(probe)
        val lit = search.litPoints(probe, texels)
        if (lit.isEmpty()) return null
        val placement = if (roles.peak ==
            Peak.DIFFUSE
        ) {
            search.place(probe, lit, texels)?.takeIf { it.error < Placement.ACCEPTED * 5 }
        } else {
            null
        }
        val cosine = placement?.let { CosineTest.of(probe, it, lit, texels) }
        if (placement == null || cosine == null) return byHint(probe, lit, texels) ?: unplaced(probe, lit, texels)
        val shared = if (cosine.error > SUSPECT) shared(probe, lit, texels) else emptyList()
        if (shared.isNotEmpty()) return LightModel.unplaced(probe, shared, null)
        val model = measured(probe, Amplitudes(probe, placement, texels, cosine.unclamped), lit, cosine)
        if ((model.attenuation?.error ?: 0.0) <= AttenuationFit.ACCEPTED && !model.otherDirection) return model
        // Near one of them, others of its colour only spoil how it fades. Near the eye there is none.
        val more = if (cosine.error > SUSPECT || model.isFromEye) emptyList() else shared(probe, lit, texels)
        return if (more.isEmpty()) bySpecular(probe, placement, cosine) ?: model else LightModel.unplaced(probe, more, null)
    }

    /** The diffuse cosine may be that with another direction, [diffuse]: what the specular term says of the light. */
    private fun bySpecular(
        probe: LightProbe,
        diffuse: Placement,
        cosine: CosineTest,
    ): LightModel? {
        if (roles.specular == null) return null
        val texels = roles.onlySpecular
        val shine = probe.shine
        val lit = search.litPoints(shine, texels)
        val placement =
            HintPlacement.of(shine, search.hints, lit, texels, Peak.SPECULAR)?.takeIf { it.view.distance(diffuse.view) > APART }
                ?: return null
        return measured(probe, Amplitudes(shine, placement, texels, unclamped = false, Peak.SPECULAR), lit, cosine, diffuse)
    }

    private fun texels(probe: LightProbe) =
        when {
            roles.diffuse != null -> roles.onlyDiffuse
            roles.specular != null -> roles.onlySpecular
            else -> probe.box.program.samplers.associate { it.name to 1.0 }
        }

    /** Without a clamped cosine nothing says where light comes from; where it would have to be is tried out. */
    private fun byHint(
        probe: LightProbe,
        lit: List<Vector3d>,
        texels: Map<String, Double>,
    ): LightModel? {
        if (roles.peak == Peak.DIFFUSE) return null
        val placement = HintPlacement.of(probe, search.hints, lit, texels, roles.peak) ?: return null
        val cosine =
            if (roles.peak == Peak.POWER) {
                CosineTest.of(probe, placement, lit, texels)
            } else {
                CosineTest(unclamped = roles.peak == Peak.TWO_SIDED, normalLength = 1.0, error = 0.0, floor = 0.0)
            }
        return measured(probe, Amplitudes(probe, placement, texels, unclamped = false, roles.peak), lit, cosine)
    }

    private fun unplaced(
        probe: LightProbe,
        lit: List<Vector3d>,
        texels: Map<String, Double>,
    ) = LightModel.unplaced(probe, shared(probe, lit, texels), HintPlacement.guess(probe, search.hints, texels))

    private fun shared(
        probe: LightProbe,
        lit: List<Vector3d>,
        texels: Map<String, Double>,
    ) = if (roles.peak == Peak.DIFFUSE) SharedColor.of(probe, lit, search.hints, texels) else emptyList()

    private fun measured(
        probe: LightProbe,
        amplitudes: Amplitudes,
        lit: List<Vector3d>,
        cosine: CosineTest,
        diffuse: Placement? = null,
    ): LightModel {
        val placement = amplitudes.placement
        val axes = search.axes.flatMap { listOf(it, Vector3d(it).negate()) }.map { placement.directionFromView(it).normalize() }
        val seen = ConeFit.of(amplitudes, lit, axes)
        val straight = AttenuationFit.of(amplitudes, seen?.brightest)
        // Towards another place that distances are measured from, a law with negative terms fits.
        val isOdd = straight.error > AttenuationFit.ACCEPTED || straight.k.run { minOf(x(), y(), z()) } < 0
        val others = search.hints.filter { it.distance(placement.view) > APART }
        val elsewhere = if (isOdd) AttenuationFit.fromElsewhere(amplitudes, others) else null
        val beam = if (isOdd && elsewhere == null) StrayBeam.of(amplitudes, lit, axes, search.hints) else null
        val isUneven = seen != null && seen.residual > UNEVEN && elsewhere == null && beam == null
        val stray = if (isUneven) StrayDistance.of(amplitudes, seen, lit, axes, search.hints) else null
        val long = if (isOdd && seen != null && elsewhere == null && beam == null) LongCone.law(amplitudes, seen) else null
        val other = if (isUneven && stray == null && long == null) StrayCone.of(amplitudes, lit, axes, search.hints) else null
        val attenuation = beam?.attenuation ?: elsewhere ?: stray?.attenuation ?: other?.attenuation ?: long ?: straight
        // Around a place that distances are not measured from, a light without a cone is uneven, too.
        val cone = if (elsewhere == null) beam?.cone ?: stray?.cone ?: other?.cone ?: seen else null
        val inside = inside(beam?.amplitudes?.placement ?: other?.let { placement.movedTo(it.from) } ?: placement, cone)
        return LightModel(
            probe = probe,
            placement = placement,
            unclamped = cosine.unclamped,
            normalLength = cosine.normalLength,
            cosineError = cosine.error,
            floor = cosine.floor,
            attenuation = attenuation,
            cone = cone,
            highlight = HighlightStudy(probe.shine, roles, amplitudes, attenuation, cone, inside, random).highlight(),
            diffuseInterpolation = if (roles.diffuse != null) InterpolationTest.of(probe, placement, inside, roles.onlyDiffuse) else null,
            otherDirection = elsewhere != null || beam != null || diffuse != null,
            hasLongCone = long != null,
            hasStrayCone = other != null,
            isFromEye = (diffuse ?: placement).view.length() < APART,
            specularInterpolation = if (roles.specular !=
                null
            ) {
                InterpolationTest.of(probe.shine, placement, inside, roles.onlySpecular)
            } else {
                null
            },
        )
    }

    /** Points that the light shines on fully, in view space. */
    private fun inside(
        placement: Placement,
        cone: ConeFit?,
    ): List<Vector3d> {
        val widest = cone?.let { if (it.inner > 0.01) it.inner * 0.9 else it.outer * 0.3 } ?: 0.0
        return List(INSIDE) {
            val direction =
                if (cone ==
                    null
                ) {
                    Directions.random(random)
                } else {
                    Directions.around(cone.axis, random.nextDouble() * widest, random.nextDouble(2 * PI))
                }
            placement.at(direction.mul(exp(random.nextDouble(-0.7, 1.4))))
        }
    }

    private companion object {
        const val APART = 1e-2
        const val INSIDE = 24
        const val SUSPECT = 5e-3

        /** Relative to full light: what no shape of a cone leaves. */
        const val UNEVEN = 1e-2
    }
}
