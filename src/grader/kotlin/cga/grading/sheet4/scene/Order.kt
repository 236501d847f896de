package cga.grading.sheet4.scene

import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.scene.LightTrack
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ObservedLight
import cga.grading.scene.Track
import cga.grading.scene.isUsable
import cga.grading.scene.maxAbs
import cga.grading.scene.translation
import org.joml.Matrix4dc
import org.joml.Vector3dc

/** Is everything set before it is drawn with? The first frame lacks what is set too late, and later ones lag behind. */
internal class Order(private val staging: Staging) {
    private val timeline = staging.timeline
    private val cast = timeline.cast
    private val lights = staging.roles.all

    /** Whether there are frames enough to tell a colour that was not there from one that grows from 0 with time. */
    private val tellsDarkness = timeline.frame(Moment.TIME_1) != null

    /** What shows that something came too late; null where the first two frames are not both there. */
    private val evidence: List<Message>? = evidence()

    /** Whether anything came too late. */
    val isLate: Boolean = !evidence.isNullOrEmpty()

    fun axis(): Axis {
        if (evidence == null) return Axis.open(Check.ORDER, say("order.no-frames"))
        if (evidence.isEmpty()) return Axis.right(Check.ORDER, 0.0, say("order.right"))
        val early = staging.events.any { it.kind == EventKind.UNIFORM_WITHOUT_PROGRAM && it.frame <= 0 }
        val mistake = if (early) Mistake.UNIFORM_BEFORE_USE else Mistake.LIGHTS_AFTER_DRAWS
        return Axis.wrong(Check.ORDER, 1.0, say("order.late", evidence.take(MOST_TEXTS)), mistake, "first frame")
    }

    private fun evidence(): List<Message>? {
        val first = timeline.frame(Moment.FIRST)
        val second = timeline.frame(Moment.SECOND) ?: return null
        val start =
            when {
                first != null -> between(first, second)
                // What is drawn without a matrix is nowhere.
                Moment.FIRST in staging.program.drawn -> listOf(say("order.no-matrix"))
                else -> return null
            }
        return start + listOfNotNull(timeline.frames.firstNotNullOfOrNull(::insideFrame)) +
            lights.filter { it.late }.map { say("order.place-before", it.name) }
    }

    private fun between(first: ObservedFrame, second: ObservedFrame): List<Message> {
        val view = if (!first.view.isUsable() && second.view.isUsable()) listOf(say("order.no-view")) else emptyList()
        return view + listOf("order.ground" to cast.ground, "order.motorcycle" to cast.motorcycle).flatMap { (key, track) ->
            val who = say(key)
            val before = track?.of(first) ?: return@flatMap emptyList()
            val after = track.of(second) ?: return@flatMap emptyList()
            val isColorless = tellsDarkness && tellsColors && isDark(before.tint) && !isDark(after.tint) && isConstant(track)
            listOfNotNull(say("order.no-color", who).takeIf { isColorless }) +
                lights.mapNotNull { lack(it, before.lights, after.lights, first.view) }.map { say("order.when-drawn", it, who) }
        }
    }

    private fun isDark(color: Vector3dc?) = color == null || color.maxAbs() < LightTrack.DARK

    /** A motorcycle whose colour never changes wears that of another thing: that costs there. */
    private val tellsColors get() = cast.motorcycle?.let { !isConstant(it) } ?: true

    /** A colour that grows from 0 with time is 0 in the first frame. */
    private fun isConstant(track: Track): Boolean {
        val tints = timeline.frames.filter { it.moment in Moment.SECOND..Moment.TIME_4 }.mapNotNull { track.of(it)?.tint }
        return tints.isNotEmpty() && tints.all { it.distance(tints.first()) < SAME }
    }

    /**
     * What [light] lacks [before] that it has [after], while nothing but time has moved. What merely differs is no sign: places and
     * colours may be set by the first update, and the first frame is drawn before it.
     */
    private fun lack(light: PlacedLight, before: List<ObservedLight>, after: List<ObservedLight>, firstView: Matrix4dc): Message? {
        val then = after.find { it.name == light.name } ?: return null
        val now = before.find { it.name == light.name }
        val changes = light.track.changesColor
        val mayBeDark = !tellsDarkness || (changes && then.color.maxAbs() < GROWING * light.track.brightest)
        return when {
            now == null -> if (mayBeDark) null else say("order.lacks", light.name)
            isUnset(now) && !isUnset(then) -> say("order.no-attenuation", light.name)
            now.color.isFinite && !isDark(now.color) -> null
            isNowhere(now, firstView) && now.position.distance(then.position) > MOVED -> say("order.no-position", light.name)
            tellsDarkness && !changes && !isDark(then.color) -> say("order.dark", light.name)
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
    private fun insideFrame(frame: ObservedFrame): Message? {
        val ground = cast.ground?.of(frame)?.lights?.associateBy { it.name } ?: return null
        val light = cast.motorcycle?.of(frame)?.lights?.find { light -> ground[light.name]?.let { differs(it, light) } ?: false }
        return light?.let { say("order.inside-frame", frame.moment, it.name) }
    }

    private fun differs(
        a: ObservedLight,
        b: ObservedLight,
    ) = listOf(a.position to b.position, a.color to b.color).any { (p, q) -> p.distance(q) > SAME * (1 + p.length()) }

    private companion object {
        const val SAME = 1e-4

        /** World units. */
        const val MOVED = 0.02

        /** Relative: what a colour that grows from 0 may have reached after a frame. */
        const val GROWING = 0.2
        const val MOST_TEXTS = 4
    }
}
