package cga.grading.sheet4.scene

import cga.grading.findings.Check
import cga.grading.findings.Mistake
import cga.grading.scene.maxAbs
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs

/** Do the motorcycle's two lights fade as the sheet's table says? What form the attenuation has is for the study of the shader. */
internal class Fading(private val staging: Staging) {
    private val roles = staging.roles
    private val pointK = staging.profile.pointK
    private val spotK = staging.profile.spotK

    /** A light's K, and by how much it differs from the table's. */
    private class Faded(val light: PlacedLight, val check: Check, wanted: Vector3dc?) {
        val k: Vector3dc = light.track.last.k
        val error = if (!isK(k)) {
            1.0
        } else if (wanted == null) {
            (if (isConstant(k)) 1.0 else 0.0)
        } else {
            difference(k, wanted)
        }
        val text = if (wanted == null) say("fade.any", light.name, k) else say("fade.k", light.name, k, wanted)
        val isWrong get() = error > NAMED
    }

    fun axes(): List<Axis> {
        // Without the motorcycle's own, another point light shows that they fade as they should.
        val model = roles.own ?: roles.further.find { !Faded(it, Check.ATTENUATION_POINT, pointK).isWrong }
        val point = model?.let { Faded(it, Check.ATTENUATION_POINT, pointK) }
        val spot = roles.spot?.let { Faded(it, Check.ATTENUATION_SPOT, spotK) }
        val missing = if (point == null) Axis.absent(Check.ATTENUATION_POINT, say("fade.no-point")).lacking(say("lack.point")) else null
        // Where no headlight can be told its absence, or that nobody can tell, is said of its presence.
        val isAbsent = spot == null && (roles.coned != null || staging.program.lent.isEmpty())
        val none = if (isAbsent) Axis.absent(Check.ATTENUATION_SPOT, say("fade.no-spot")).lacking(say("lack.spot")) else null
        return listOfNotNull(missing, none) + listOfNotNull(point, spot).map { axis(it, point, spot) } + listOfNotNull(lastSent())
    }

    private fun axis(faded: Faded, point: Faded?, spot: Faded?): Axis {
        if (faded.isWrong && isWorn(faded.light)) return Axis.right(faded.check, 0.0, say("fade.worn", faded.light.name))
        if (!faded.isWrong) return Axis.right(faded.check, faded.error, faded.text)
        val mistake = mistake(faded, point, spot)
        // The table's rows are one thing: both that are wrong cost at the first.
        val explains = if (mistake.check in PAIR) emptySet() else PAIR
        val wrong = Axis.wrong(faded.check, faded.error, faded.text, mistake, faded.light.name, explains = explains)
        return if (isK(faded.k)) wrong else wrong.lacking(say("lack.attenuation", faded.light.name), Check.ATTENUATION_FORM)
    }

    /** One thing changed in the table: the other row, no fading, no last column, or other numbers. */
    private fun mistake(faded: Faded, point: Faded?, spot: Faded?): Mistake {
        val wrong = listOfNotNull(point, spot).filter { it.isWrong && !isWorn(it.light) }
        return when {
            !isK(faded.k) -> Mistake.ATTENUATION_OTHER_K
            wrong.all { isConstant(it.k) } -> Mistake.ATTENUATION_MISSING
            pointK == null || spotK == null -> Mistake.ATTENUATION_OTHER_K
            wrong.singleOrNull() === spot && difference(faded.k, pointK) <= NAMED -> Mistake.ATTENUATION_ONE_K
            wrong.singleOrNull() === point && spot != null && difference(faded.k, spotK) <= NAMED -> Mistake.ATTENUATION_LAST_K
            wrong.all { abs(it.k.z()) < NOTHING && it.k.y() > 0 } -> Mistake.ATTENUATION_LINEAR
            else -> Mistake.ATTENUATION_OTHER_K
        }
    }

    /** Where any K is right, one that another light's was sent over is not: each of them was meant for its own light. */
    private fun lastSent(): Axis? {
        val own = roles.own?.takeIf { pointK == null } ?: return null
        val names = own.track.last.fadedBy.intersect(staging.overwritten)
        val others = (roles.all - own).filter { names.isNotEmpty() && it.track.last.fadedBy.containsAll(names) }
        if (others.isEmpty()) return null
        val where = (listOf(own) + others).joinToString { it.name }
        return Axis.wrong(Check.ATTENUATION_POINT, 1.0, say("fade.last", where, own.track.last.k), Mistake.ATTENUATION_LAST_K, where)
    }

    /** Whether the motorcycle's light is overwritten by the headlight with all that is sent for it: that costs at the place. */
    private fun isWorn(light: PlacedLight): Boolean {
        val spot = roles.spot ?: return false
        return light === roles.own && light !== spot && staging.isOverwritten(light) &&
            spot.track.last.k.distance(light.track.last.k) < NOTHING && staging.isOneColor(spot, light)
    }

    private companion object {
        val PAIR = setOf(Check.ATTENUATION_POINT, Check.ATTENUATION_SPOT)
        const val NAMED = 0.03
        const val NOTHING = 1e-6

        /** World units: from beside the motorcycle to the corners of the ground. */
        val DISTANCES = listOf(0.5, 1.0, 2.0, 4.0, 8.0, 16.0)

        /** Whether these are numbers at all, and anything but 0. */
        fun isK(k: Vector3dc) = k.isFinite && k.maxAbs() >= NOTHING

        fun isConstant(k: Vector3dc) = abs(k.y()) < NOTHING && abs(k.z()) < NOTHING && k.x() > 0

        /** The largest relative difference of the two factors over all [DISTANCES]. */
        fun difference(
            k: Vector3dc,
            expected: Vector3dc,
        ): Double = DISTANCES.maxOf { d -> Vector3d(1.0, d, d * d).let { abs(expected.dot(it) / k.dot(it) - 1) } }
    }
}
