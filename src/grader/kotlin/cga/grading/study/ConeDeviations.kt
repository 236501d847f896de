package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.round

/** What is wrong with a light's cone. */
internal object ConeDeviations {
    private val BENT = setOf(Falloff.SMOOTH, Falloff.IN_ANGLE, Falloff.POWER, Falloff.OTHER)

    /** These tell nothing of the angle that they were made of. */
    private val COSINES = setOf(AngleForm.COSINE, AngleForm.VERSINE)

    /** The mistakes in the cone of [light]; [numbers] are all that uniforms hold, [lengths] those of the vectors along its axis. */
    fun of(
        light: LightModel,
        numbers: Collection<Double>,
        lengths: Collection<Double> = emptyList(),
    ): List<Deviation> {
        val cone = light.cone ?: return emptyList()

        fun found(
            mistake: Mistake,
            difference: Double = 1.0,
        ) = listOf(Deviation(mistake, light.name, cone.error, difference))
        val isInverted = cone.inner > PI / 2
        // Lit away from the axis: seen from the other side of it, the edges change sign.
        val cosFull = if (isInverted) -cone.cosInner else cone.cosInner
        val cosDark = if (isInverted) -cone.cosOuter else cone.cosOuter
        val words = ConeWords.of(cosFull, cosDark, numbers) ?: ConeWords.of(-cosFull, -cosDark, numbers)
        val values = words?.let(::valueMistake)
        val length = if (words == null) AxisLength.of(cone, numbers, lengths) else null
        return when {
            light.hasLongCone -> listOf(unknown(light, cone, 1.0, LONG_TEXT))
            light.hasStrayCone -> listOf(unknown(light, cone, 1.0, STRAY_TEXT))
            isTwofold(cone) -> listOf(unknown(light, cone, 1.0, TWOFOLD_TEXT))
            cone.falloff == Falloff.HARD -> found(Mistake.CONE_HARD_EDGE)
            cone.falloff == Falloff.COSINE_TWICE -> found(Mistake.COSINE_OF_COSINE)
            values != null -> found(values)
            length != null -> listOf(unknown(light, cone, 1.0, AxisLength.text(length)))
            words == null && areDegrees(cone) && !looksChosen(cone) -> found(Mistake.DEGREES_FOR_RADIANS)
            words?.form in COSINES && cone.outer > WIDE && areDegrees(cone) && !looksChosen(cone) -> found(Mistake.DEGREES_FOR_RADIANS)
            cone.falloff == Falloff.UNCLAMPED -> found(Mistake.CONE_CLAMP_MISSING)
            cone.falloff == Falloff.UNCLAMPED_ABOVE && !startsAtAxis(light, numbers) -> found(Mistake.CONE_CLAMP_MISSING)
            words == null && areCosines(cosFull, cosDark) -> found(Mistake.COSINE_OF_COSINE)
            isInverted -> found(Mistake.CONE_INSIDE_OUT)
            cone.intensities.min() > LEFT -> listOf(unknown(light, cone, cone.intensities.min(), LEFT_TEXT))
            cone.falloff in BENT -> listOf(unknown(light, cone, cone.error, BEND[cone.falloff].orEmpty()))
            else -> emptyList()
        }
    }

    private fun unknown(
        light: LightModel,
        cone: ConeFit,
        difference: Double,
        why: String,
    ) = Deviation(Mistake.UNKNOWN, light.name, cone.residual, difference, check = Check.CONE, why = why)

    private fun areDegrees(cone: ConeFit) =
        ConeWords.areDegreesInRadians(cone.inner, cone.outer) || ConeWords.areDegreesInRadians(PI - cone.inner, PI - cone.outer)

    /**
     * Whether both edges, as angles, are the cosines of whole degrees and no such angles themselves, and the one of full light is the larger:
     * a narrower angle has the larger cosine. Constants of a shader say no more.
     */
    private fun areCosines(
        cosFull: Double,
        cosDark: Double,
    ): Boolean {
        val angles = listOf(cosFull, cosDark).map { acos(it.coerceIn(-1.0, 1.0)) }
        return angles[0] > angles[1] && angles.all { it < 1 && isWhole(acos(it)) && !isWhole(it) }
    }

    private fun isWhole(radians: Double) = Math.toDegrees(radians).let { abs(it - round(it)) < WHOLE }

    private fun looksChosen(cone: ConeFit) = ConeWords.isRound(cone.inner) && ConeWords.isRound(cone.outer)

    /** What was sent was not what the shader takes it for. */
    private fun valueMistake(words: ConeWords): Mistake? {
        val sent = listOf(words.full, words.dark)
        return when (words.form) {
            AngleForm.COSINE_TWICE -> Mistake.COSINE_OF_COSINE
            AngleForm.ANGLE ->
                if (sent.any { it > PI / 2 }) {
                    Mistake.DEGREES_FOR_RADIANS
                } else if (sent.all(ConeWords::isRoundCosine) && sent.none(ConeWords::isRound)) {
                    Mistake.COSINE_OF_COSINE
                } else {
                    null
                }
            // An angle that was a cosine already, and a cosine taken of it: the narrower one is the wider now.
            AngleForm.COSINE ->
                sent.map { acos(it.coerceIn(-1.0, 1.0)) }.let { angles ->
                    val isTwice = angles[0] > angles[1] && angles.all(ConeWords::isRoundCosine) && angles.none(ConeWords::isRound)
                    if (isTwice) Mistake.COSINE_OF_COSINE else null
                }
            AngleForm.DEGREES -> if (sent.all { it < PI / 2 && ConeWords.isRound(it) && it > 0 }) Mistake.DEGREES_FOR_RADIANS else null
            else -> null
        }
    }

    /** Whether it shines to the front and to the back, and to no side. */
    private fun isTwofold(cone: ConeFit) =
        cone.intensities.run { first() > FULL && last() > FULL && min() < LEFT }

    /** Whether the light has full strength on its axis only because its inner angle is 0: then it is no brighter there than its K say. */
    private fun startsAtAxis(
        light: LightModel,
        numbers: Collection<Double>,
    ): Boolean {
        val k = light.attenuation?.k ?: return false
        return listOf(k.x(), k.y(), k.z()).filter { it > 0 }.all { part -> numbers.any { abs(it - part) < 1e-4 * part } }
    }

    private val BEND =
        mapOf(
            Falloff.SMOOTH to "between the cones the light fades by smoothstep",
            Falloff.IN_ANGLE to "between the cones the light fades with the angle, not with its cosine",
            Falloff.POWER to "between the cones the light fades with a power of the sheet's I",
        )

    /** Of full light, beyond the outer edge. */
    private const val LEFT = 0.02
    private const val FULL = 0.5
    private const val TWOFOLD_TEXT = "it shines in two cones, one to the front and one to the back"
    private const val LONG_TEXT = "its cosine is taken with a long vector to the light, so it is the wider the farther it reaches"
    private const val STRAY_TEXT = "its cosine is taken with the vector to another light or to the camera"
    private const val LEFT_TEXT = "outside of the cone it is not dark"

    /** Radians: wider than any headlight. */
    private const val WIDE = PI / 4

    /** Degrees: an edge found to 1e-6 as a cosine is found to some 1e-5 as the angle whose cosine it is; two meet it by chance once in 600. */
    private const val WHOLE = 0.02
}
