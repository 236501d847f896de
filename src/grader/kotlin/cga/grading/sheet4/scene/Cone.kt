package cga.grading.sheet4.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.ObservedCone
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.acos
import kotlin.math.cos
import kotlin.math.round

/**
 * Whether the two angles of a cone make sense as numbers: each mistake is what a wrong conversion makes of whole numbers of degrees. What
 * the shader makes of them is for the study of the shader, which sees more.
 */
internal object Cone {
    fun axis(cone: ObservedCone, name: String): Axis {
        val inner = cone.innerAngle
        val outer = cone.outerAngle
        val edges = say("cone.edges", degrees(inner), degrees(outer))
        val mistake = mistake(inner, outer) ?: return Axis.right(CHECK, 0.0, say("cone.right", edges))
        if (isOfTwice(inner) && isOfTwice(outer)) {
            // Whatever a shader makes of such numbers: that its highlights are right as well is no excuse.
            return Axis.wrong(CHECK, 1.0, say("cone.twice", edges), mistake, name, explains = setOf(Check.CONE_SPECULAR))
        }
        // A hard edge is a cone all the same.
        val error = if (mistake == Mistake.CONE_HARD_EDGE) HARD_EDGE else 1.0
        val ties = if (mistake == Mistake.CONE_INSIDE_OUT && inner <= 1) listOf(Mistake.COSINE_OF_COSINE) else emptyList()
        val wrong = Axis.wrong(CHECK, error, say("cone.wrong", edges), mistake, name, alternatives = ties)
        if (mistake != Mistake.CONE_NEVER_SENT) return wrong
        return wrong.lacking(say("lack.cone", name), Check.SPOT_DIRECTION, Check.CONE_SPECULAR)
    }

    private fun mistake(inner: Double, outer: Double): Mistake? =
        when {
            inner.isNaN() || outer.isNaN() -> Mistake.CONE_NEVER_SENT
            isOfTwice(inner) && isOfTwice(outer) -> Mistake.DEGREES_FOR_RADIANS
            abs(inner - outer) <= SAME && isNothing(inner) -> Mistake.CONE_NEVER_SENT
            // Wider than any headlight, of angles that are whole numbers of degrees only when these are taken for radians.
            maxOf(inner, outer) > WIDE && listOf(inner, outer).all { isOfDegrees(it) && !isRound(it) } -> Mistake.DEGREES_FOR_RADIANS
            inner > outer + SAME && isCosine(inner) && isCosine(outer) && !(isRound(inner) && isRound(outer)) -> Mistake.COSINE_OF_COSINE
            inner > outer + SAME -> Mistake.CONE_INSIDE_OUT
            outer > RIGHT_ANGLE -> Mistake.DEGREES_FOR_RADIANS
            outer - inner <= SAME -> Mistake.CONE_HARD_EDGE
            else -> null
        }

    /** What is left where nothing was sent: the angle 0, or the cosine 0. */
    private fun isNothing(angle: Double) = abs(angle) <= SAME || abs(angle - PI / 2) <= SAME

    private fun isRound(angle: Double) = isWhole(Math.toDegrees(angle))

    /** Whether [angle] is the cosine of a whole number of degrees. */
    private fun isCosine(angle: Double) = angle in 0.0..1.0 && isWhole(Math.toDegrees(acos(angle)))

    private fun isWhole(degrees: Double) = abs(degrees - round(degrees)) <= WHOLE

    /** Whether [angle] has the cosine of a whole number of degrees that was taken for radians. */
    private fun isOfDegrees(angle: Double) = (1..MOST_DEGREES).any { abs(cos(it.toDouble()) - cos(angle)) <= CLOSE }

    /** Whether [angle] is a whole number of degrees that was made radians twice. */
    private fun isOfTwice(angle: Double) =
        angle > 0 && (1..MOST_DEGREES).any { abs(cos(Math.toRadians(Math.toRadians(it.toDouble()))) - cos(angle)) <= ROUNDED }

    private fun degrees(angle: Double) = if (angle.isNaN()) say("cone.no-angle") else say("cone.degrees", angle)

    private val CHECK = Check.CONE

    /** Radians: what an angle is found to by watching where light ends. */
    private const val SAME = 1e-3

    /** As a cosine; a whole number of degrees is met by chance by one angle in a hundred, and by two hardly ever. */
    private const val CLOSE = 2e-4

    /** What a cosine next to 1 is rounded by as a float: 2⁻²⁴ when it is made, and as much when it is read. */
    private const val ROUNDED = 1.2e-7

    /** Degrees. */
    private const val WHOLE = 0.03
    private const val MOST_DEGREES = 90
    private const val WIDE = PI / 4
    private const val RIGHT_ANGLE = PI / 2 + SAME
    private const val HARD_EDGE = 0.5
}
