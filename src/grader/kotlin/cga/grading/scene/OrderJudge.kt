package cga.grading.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Matrix4dc
import org.joml.Vector3dc

/** Is everything set before it is drawn with? The first frame lacks what is set too late, and later ones lag behind. */
internal class OrderJudge(
    private val timeline: Timeline,
    private val roles: LightRoles,
    private val events: List<CapturedEvent>,
    private val drawn: Set<Moment>,
    private val book: Notebook,
) {
    private val cast = timeline.cast
    private val lights = listOfNotNull(roles.own, roles.spot) + roles.further
    private val evidence = ArrayList<String>()

    /** Whether there are frames enough to tell a colour that was not there from one that grows from 0 with time. */
    private val mayTellDarkness = timeline.frame(Moment.TIME_1) != null

    /** A motorcycle whose colour never changes wears that of another thing: that costs there. */
    private val mayTellColors = cast.motorcycle?.let { !isConstant(it) } ?: true

    fun judge() {
        val first = timeline.frame(Moment.FIRST)
        val second = timeline.frame(Moment.SECOND)
        when {
            first != null && second != null -> firstAgainstSecond(first, second)
            // What is drawn without a matrix is nowhere.
            second != null && Moment.FIRST in drawn -> evidence += "the first frame lacks a matrix"
            else -> return book.measured(Check.ORDER, null, "The first two frames are not both there.")
        }
        timeline.frames.firstNotNullOfOrNull(::insideFrame)?.let(evidence::add)
        lights.filter { it.placed.late }.forEach { evidence += "${it.name} is where it was a frame before" }
        if (evidence.isEmpty()) return book.measured(Check.ORDER, 0.0, "The first frame shows what the second does.")
        book.measured(Check.ORDER, 1.0, evidence.take(MOST_TEXTS).joinToString("; ", "Too late: ", "."))
        val early = events.any { it.kind == EventKind.UNIFORM_WITHOUT_PROGRAM && it.frame <= 0 }
        book.found(if (early) Mistake.UNIFORM_BEFORE_USE else Mistake.LIGHTS_AFTER_DRAWS, 0.0, 1.0, evidence.first())
    }

    private fun firstAgainstSecond(
        first: ObservedFrame,
        second: ObservedFrame,
    ) {
        if (!first.view.isUsable() && second.view.isUsable()) evidence += "the first frame has no view matrix"
        for ((who, track) in listOf("the ground" to cast.ground, "the motorcycle" to cast.motorcycle)) {
            val before = track?.of(first) ?: continue
            val after = track.of(second) ?: continue
            val isColorless = mayTellDarkness && mayTellColors && before.tint.isDark() && !after.tint.isDark() && isConstant(track)
            if (isColorless) evidence += "the first frame has no colour for $who"
            for (light in lights) {
                val lack = light.late(before.lights, after.lights, first.view) ?: continue
                evidence += "the first frame $lack when $who is drawn"
            }
        }
    }

    private fun Vector3dc?.isDark() = this == null || maxAbs() < LightTrack.DARK

    /** A colour that grows from 0 with time is 0 in the first frame. */
    private fun isConstant(track: Track): Boolean {
        val tints = STANDING.mapNotNull { moment -> timeline.frame(moment)?.let(track::of)?.tint }
        return tints.isNotEmpty() && tints.all { it.distance(tints.first()) < SAME }
    }

    /**
     * What the light lacks [before] that it has [after], while nothing but time has moved. What merely differs is no sign: places and
     * colours may be set by the first update, and the first frame is drawn before it.
     */
    private fun LightTrack.late(
        before: List<ObservedLight>,
        after: List<ObservedLight>,
        firstView: Matrix4dc,
    ): String? {
        val then = after.find { it.name == name } ?: return null
        val now = before.find { it.name == name }
        val isDark = now == null || !now.color.isFinite || now.color.maxAbs() < LightTrack.DARK
        val mayBeDark = !mayTellDarkness || (changesColor && then.color.maxAbs() < GROWING * brightest)
        return when {
            now == null -> if (mayBeDark) null else "lacks $name"
            isUnset(now) && !isUnset(then) -> "has no attenuation of $name"
            !isDark -> null
            isNowhere(now, firstView) && now.position.distance(then.position) > MOVED -> "has no position of $name"
            mayTellDarkness && !changesColor && then.color.maxAbs() > LightTrack.DARK -> "has $name dark"
            else -> null
        }
    }

    /** Whether the position is what a uniform that nobody has set makes of it: the origin of view space or of the world. */
    private fun isNowhere(
        light: ObservedLight,
        view: Matrix4dc,
    ) = !light.position.isFinite || minOf(light.position.length(), light.position.distance(view.translation())) < SAME

    private fun isUnset(light: ObservedLight) = !light.k.isFinite || light.k.maxAbs() < LightTrack.DARK

    /** Whether draws of one frame see different lights: some then see those of the frame before. */
    private fun insideFrame(frame: ObservedFrame): String? {
        val ground = cast.ground?.of(frame)?.lights?.associateBy { it.name } ?: return null
        val motorcycle = cast.motorcycle?.of(frame)?.lights ?: return null
        val light = motorcycle.find { light -> ground[light.name]?.let { differs(it, light) } ?: false } ?: return null
        return "in ${frame.moment} ground and motorcycle are drawn with different states of ${light.name}"
    }

    private fun differs(
        a: ObservedLight,
        b: ObservedLight,
    ): Boolean =
        a.position.distance(b.position) > SAME * (1 + a.position.length()) || a.color.distance(b.color) > SAME * (1 + a.color.length())

    private companion object {
        val STANDING = listOf(Moment.SECOND, Moment.TIME_1, Moment.TIME_2, Moment.TIME_3, Moment.TIME_4)
        const val SAME = 1e-4

        /** World units. */
        const val MOVED = 0.02

        /** Relative: what a colour that grows from 0 may have reached after a frame. */
        const val GROWING = 0.2
        const val MOST_TEXTS = 4
    }
}
