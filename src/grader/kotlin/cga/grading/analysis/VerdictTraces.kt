package cga.grading.analysis

import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Mistake

/** Which mistakes are only traces of others, and what they take with them. */
internal object VerdictTraces {
    /** What costs more than its own check: what a light that is not there lacks, or a colour. */
    private val ABSENT =
        mapOf(
            Mistake.LIGHT_MISSING to
                setOf(Check.POINT_LIGHT, Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.ATTENUATION_POINT, Check.LIGHT_COLOR),
            Mistake.SPOT_MISSING to
                setOf(Check.SPOT_LIGHT, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE, Check.CONE_SPECULAR) +
                Check.ATTENUATION_SPOT,
            Mistake.MORE_LIGHTS_MISSING to setOf(Check.MORE_LIGHTS, Check.MORE_LIGHTS_SHADING),
            Mistake.EMISSION_COLOR_IGNORED to setOf(Check.EMISSION, Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR),
        )
    private val MISSING = setOf(Mistake.LIGHT_MISSING, Mistake.SPOT_MISSING, Mistake.MORE_LIGHTS_MISSING)

    private val LOSSES = setOf(Mistake.UNIFORM_ABSENT, Mistake.UNIFORM_BEFORE_USE)

    /** What numbers that never arrive look like. */
    private val LOST =
        MISSING +
            setOf(
                Mistake.CONE_NEVER_SENT, Mistake.SPECULAR_MISSING, Mistake.EXPONENT_FIXED, Mistake.ATTENUATION_MISSING,
                Mistake.ATTENUATION_OTHER_K, Mistake.TO_LIGHT_WORLD, Mistake.LIGHT_POSITION_OVERWRITTEN, Mistake.UNKNOWN,
            )

    /** What may be wrong with a cone; and what half a one looks like, where its other number never arrives. */
    val CONES: Set<Mistake> = Mistake.entries.filter { it.check == Check.CONE }.toSet()
    private val EMISSION = setOf(Mistake.EMISSION_COLOR_IGNORED, Mistake.EMISSION_MULTIPLIED, Mistake.EMISSION_MISSING)

    /** By the cause: what it may look like. Where light cannot be placed without a diffuse term, nothing of it is seen. */
    private val TRACES: Map<Mistake, Set<Mistake>> =
        mapOf(
            Mistake.UNIFORM_ABSENT to LOST,
            Mistake.UNIFORM_BEFORE_USE to LOST,
            Mistake.DIFFUSE_MISSING to
                MISSING +
                setOf(Mistake.SPECULAR_MISSING, Mistake.LIGHT_COLOR_DIFFERS, Mistake.SPOT_DIRECTION_LOCAL, Mistake.ATTENUATION_OTHER_K),
            // Of lights of one colour only where they are is told apart well, and not what a cone leaves of one.
            Mistake.LATER_LIGHTS_FIRST_COLOR to
                setOf(
                    Mistake.MORE_LIGHTS_MISSING,
                    Mistake.MORE_LIGHTS_ALIKE,
                    Mistake.LIGHT_MISSING,
                    Mistake.SPOT_MISSING,
                    Mistake.ATTENUATION_OTHER_K,
                ),
            Mistake.LATER_LIGHTS_FIRST_COSINE to
                setOf(
                    Mistake.NORMAL_MATRIX, Mistake.TO_LIGHT_WORLD, Mistake.LIGHT_POSITION_OVERWRITTEN, Mistake.SPOT_DIRECTION_LOCAL,
                    Mistake.SPOT_DIRECTION_WORLD, Mistake.SPOT_DIRECTION_SIGN,
                ),
            Mistake.LIGHT_POSITION_OVERWRITTEN to setOf(Mistake.MORE_LIGHTS_ALIKE),
            Mistake.CONE_NEVER_SENT to setOf(Mistake.SPOT_MISSING),
            // The angle to the axis is measured with the same vector.
            Mistake.LIGHT_VECTOR_SIGN to setOf(Mistake.SPOT_DIRECTION_SIGN),
        ) +
            // A cone that is lit outside looks like one that points the other way.
            listOf(Mistake.CONE_INSIDE_OUT, Mistake.COSINE_OF_COSINE, Mistake.DEGREES_FOR_RADIANS).associateWith {
                setOf(Mistake.SPOT_DIRECTION_SIGN)
            } +
            // The study tells these apart; without it the scene only sees that there is no colour.
            EMISSION.associateWith { setOf(Mistake.COLOR_CONSTANT, Mistake.EMISSION_COLOR_IGNORED) - it }

    /** Whether [found] is a trace of [cause]. What only comes a frame too late ([Found.explains] names nothing) leaves none. */
    fun isTrace(
        found: Found,
        cause: Found,
    ): Boolean {
        if (found.mistake in CONES && isLossOfCone(cause)) return true
        if (found.mistake in CONES && cause.mistake == Mistake.UNIFORM_ABSENT) return false
        if (found.mistake !in TRACES[cause.mistake].orEmpty()) return false
        return cause.mistake !in LOSSES || isLoss(cause)
    }

    /** Whether [found] says that numbers never arrive, and not only in the first frame. */
    fun isLoss(found: Found): Boolean = found.mistake in LOSSES && !found.explains.isNullOrEmpty()

    /** Whether [found] says so of the numbers of a cone. */
    fun isLossOfCone(found: Found): Boolean = isLoss(found) && Check.CONE in found.explains.orEmpty()

    /** The checks that [trace] would have cost. */
    fun checks(trace: Mistake): Set<Check> = ABSENT[trace] ?: setOf(trace.check)

    /** Whether [mistake] says that a light is not there. */
    fun saysMissing(mistake: Mistake): Boolean = mistake in MISSING

    /** How many lights are missing, at least, where [mistake] is made. */
    fun lights(mistake: Mistake): Int = if (mistake == Mistake.MORE_LIGHTS_MISSING) {
        2
    } else if (saysMissing(mistake)) {
        1
    } else {
        0
    }

    /** What the study measures by light: where none arrives, it is measured of nothing. */
    val SHADING: Set<Check> =
        setOf(
            Check.DIFFUSE, Check.SPECULAR, Check.NORMALS, Check.INTERPOLATION, Check.MATERIAL, Check.CONE, Check.CONE_SPECULAR,
            Check.ATTENUATION_FORM, Check.MORE_LIGHTS_SHADING, Check.HALF_VECTOR,
        )
}
