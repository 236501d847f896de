package cga.grading.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs

/** Do the motorcycle's two lights fade as the sheet's table says? What form the attenuation has is for the study of the shader. */
internal class AttenuationJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val profile: SceneProfile,
    events: List<CapturedEvent>,
    private val book: Notebook,
) {
    private val overwritten = events.filter { it.kind == EventKind.UNIFORM_OVERWRITTEN }.map { it.text }.toSet()
    private val pointK = profile.pointK
    private val spotK = profile.spotK

    fun judge() {
        // Without the motorcycle's own, another point light shows that they fade as they should.
        val model = roles.own ?: roles.further.find { isRight(it.last.k, pointK) }
        val point = measure(model, pointK, Check.ATTENUATION_POINT, "There is no point light that could fade.")
        val spot = measure(roles.spot, spotK, Check.ATTENUATION_SPOT, "There is no spotlight that could fade.")
        name(point, spot)
        if (point == null && pointK == null) overwritten()
    }

    /** Where any K is right, one that another light's was sent over is not: each of them was meant for its own light. */
    private fun overwritten() {
        val own = roles.own ?: return
        val names = own.last.fadedBy.intersect(overwritten)
        val others = (listOfNotNull(roles.spot) + roles.further).filter { names.isNotEmpty() && it.last.fadedBy.containsAll(names) }
        if (others.isEmpty()) return
        val where = (listOf(own) + others).joinToString(", ") { it.name }
        book.measured(Check.ATTENUATION_POINT, 1.0, "$where: K = ${own.last.k.text()}, the last one's that was sent; wanted: each its own.")
        book.found(Mistake.ATTENUATION_LAST_K, 0.0, 1.0, where)
    }

    /** A light's K that differs from the table's. */
    private class Other(
        val light: LightTrack,
        val k: Vector3dc,
        val error: Double,
    )

    /** Puts the check down, and returns the light where it is wrong. */
    private fun measure(
        light: LightTrack?,
        expected: Vector3dc?,
        check: Check,
        missing: String,
    ): Other? {
        if (light == null) {
            book.absent(check, missing)
            return null
        }
        val k = light.last.k
        val error = if (expected == null) (if (isConstant(k)) 1.0 else 0.0) else difference(k, expected)
        val wanted = if (expected == null) "any that fades" else expected.text()
        if (error > NAMED && isWorn(light)) {
            book.measured(check, 0.0, "${light.name} has the K of the headlight, and its place as well: that costs at the place.")
            return null
        }
        book.measured(check, error, "${light.name}: K = ${k.text()}; wanted $wanted.")
        if (!k.isFinite || k.maxAbs() < NOTHING) {
            book.lacks("the attenuation of ${light.name}", setOf(check, Check.ATTENUATION_FORM), setOf(Mistake.ATTENUATION_OTHER_K))
        }
        return if (error > NAMED) Other(light, k, error) else null
    }

    private fun isRight(
        k: Vector3dc,
        expected: Vector3dc?,
    ) = k.isFinite && k.maxAbs() >= NOTHING && (if (expected == null) !isConstant(k) else difference(k, expected) <= NAMED)

    /** Whether the motorcycle's light is overwritten by the headlight with all that is sent for it: that costs at the place. */
    private fun isWorn(light: LightTrack?) =
        light != null && light === roles.own && book.has(Mistake.LIGHT_POSITION_OVERWRITTEN) &&
            roles.spot?.let { it !== light && it.last.k.distance(light.last.k) < NOTHING && timeline.isOneColor(it, light) } == true

    private fun name(
        point: Other?,
        spot: Other?,
    ) {
        val wrong = listOfNotNull(point, spot)
        if (wrong.isEmpty()) return
        val where = wrong.joinToString(" and ") { it.light.name }
        val error = wrong.maxOf { it.error }
        when {
            wrong.all { isConstant(it.k) } -> book.found(Mistake.ATTENUATION_MISSING, 0.0, error, where)
            pointK == null || spotK == null -> book.found(Mistake.ATTENUATION_OTHER_K, 1.0, error, where)
            point == null && spot != null && difference(spot.k, pointK) <= NAMED -> {
                book.found(Mistake.ATTENUATION_ONE_K, difference(spot.k, pointK), error, where)
            }
            spot == null && point != null && roles.spot != null && difference(point.k, spotK) <= NAMED -> {
                book.found(Mistake.ATTENUATION_LAST_K, difference(point.k, spotK), error, where)
            }
            wrong.all { it.k.z() == 0.0 || abs(it.k.z()) < NOTHING } && wrong.all { it.k.y() > 0 } -> {
                book.found(Mistake.ATTENUATION_LINEAR, 0.0, error, where)
            }
            else -> book.found(Mistake.ATTENUATION_OTHER_K, 0.0, error, where)
        }
    }

    private companion object {
        const val NAMED = 0.03
        const val NOTHING = 1e-6

        /** World units: from beside the motorcycle to the corners of the ground. */
        val DISTANCES = listOf(0.5, 1.0, 2.0, 4.0, 8.0, 16.0)

        fun isConstant(k: Vector3dc) = abs(k.y()) < NOTHING && abs(k.z()) < NOTHING && k.x() > 0

        /** The largest relative difference of the two factors over all [DISTANCES]. */
        fun difference(
            k: Vector3dc,
            expected: Vector3dc,
        ): Double = DISTANCES.maxOf { d -> Vector3d(1.0, d, d * d).let { abs(expected.dot(it) / k.dot(it) - 1) } }
    }
}
