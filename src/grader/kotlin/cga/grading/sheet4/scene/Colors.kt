package cga.grading.sheet4.scene

import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Message
import cga.grading.findings.Mistake
import cga.grading.scene.Equation
import cga.grading.scene.Track
import cga.grading.scene.fit
import cga.grading.scene.maxAbs
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.max

/**
 * Task 4.4: the ground's colour stays, the motorcycle's changes with time, its light shines in the same.
 *
 * @param isSent whether something is sent that a shader declares and does not use: then a colour that nothing shows may have been sent.
 * @param isLate whether the motorcycle's light is bound too late, which costs at the order.
 */
internal class Colors(private val staging: Staging, private val isSent: Boolean, private val isLate: Boolean) {
    private val timeline = staging.timeline
    private val cast = timeline.cast

    private class Tint(val moment: Moment, val time: Double, val color: Vector3dc)

    private val sent = listOf(cast.ground, cast.motorcycle).map(::tints)

    // White everywhere and always, written into the shader while a colour is sent to nobody, is none.
    private val isNone = isSent && sent.flatten().all { it.color.distance(WHITE) < DARK }
    private val ground = if (isNone) emptyList() else sent[0]
    private val motorcycle = if (isNone) emptyList() else sent[1]
    private val both = ground + motorcycle
    private val isStill = motorcycle.isNotEmpty() && spread(motorcycle) <= CHANGE

    fun axes(): List<Axis> {
        if (both.isEmpty()) return listOf(ground(), motorcycle(), light(), ignored())
        if (both.all { it.color.maxAbs() < DARK }) return black() + light()
        return listOf(ground(), motorcycle(), light())
    }

    /** No colour is multiplied with any emission. */
    private fun ignored(): Axis {
        val explains = if (isSent) setOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR) else emptySet()
        val ties = listOf(Mistake.COLOR_CONSTANT)
        val found = Axis.found(Mistake.EMISSION_COLOR_IGNORED, "ground and motorcycle", alternatives = ties, explains = explains)
        return Axis.named(found, null)
    }

    /** Nothing is there, or it was sent and cannot be seen: then what does not take it costs. */
    private fun none(check: Check, text: Message) = Axis.absent(check, text)

    /** The emission is multiplied with black, always: no colour arrives. */
    private fun black(): List<Axis> {
        val checks = setOf(Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR)
        return checks
            .map { Axis.wrong(it, 1.0, say("color.black"), Mistake.EMISSION_MISSING, "ground and motorcycle", explains = checks) }
            .map { it.lacking(say("lack.colour"), kind = LackKind.COLOR) }
    }

    private fun tints(track: Track?): List<Tint> =
        timeline.frames.filter { it.moment != Moment.FIRST }.mapNotNull { frame ->
            track?.of(frame)?.tint?.takeIf { it.isFinite }?.let { Tint(frame.moment, frame.time, it) }
        }

    private fun ground(): Axis {
        if (cast.ground == null) return Axis.open(Check.GROUND_COLOR, say("color.no-ground"))
        val color = ground.lastOrNull()?.color ?: return none(Check.GROUND_COLOR, say("color.no-ground-colour"))
        val change = spread(ground) / max(ground.maxOf { it.color.maxAbs() }, DARK)
        val (error, text) =
            when {
                // Each thing is drawn in the colour of the one before.
                change > CHANGE && isStill -> 0.0 to say("color.exchanged")
                change > STILL -> change to say("color.ground-changes", list(ground))
                color.distance(WHITE) < PLAIN -> 1.0 to say("color.ground-white")
                color.maxAbs() < PLAIN -> 1.0 to say("color.ground-black")
                else -> 0.0 to say("color.ground-is", color)
            }
        return Axis.right(Check.GROUND_COLOR, error, text)
    }

    private fun motorcycle(): Axis {
        val check = Check.MOTORCYCLE_COLOR
        val last = motorcycle.lastOrNull() ?: return none(check, say("color.no-motorcycle-colour"))
        val standing = motorcycle.filter { it.moment in STANDING }
        if (standing.size < 2) return Axis.open(check, say("color.few-frames"))
        val isOfStep = !isStill && isOfStep()
        val text =
            when {
                isOfStep -> say("color.of-step")
                // A colour that update() only sets once the motorcycle drives.
                !isStill && spread(standing) < SAME -> say("color.only-driven")
                !isStill -> return Axis.right(check, 0.0, say("color.changes", list(standing)))
                else -> say("color.always", last.color)
            }
        // A constant of the shader lets none through that the program sends.
        if (isWritten()) return Axis.wrong(check, 1.0, text, Mistake.EMISSION_COLOR_IGNORED, "motorcycle", explains = setOf(check))
        val wrong = Axis.wrong(check, 1.0, text, Mistake.COLOR_CONSTANT, "motorcycle")
        val isBlack = motorcycle.all { it.color.maxAbs() < DARK }
        return when {
            isBlack -> wrong.lacking(say("lack.colour"), kind = LackKind.COLOR)
            isWorn() -> wrong.lacking(say("lack.own-colour"), kind = LackKind.OWN_COLOR)
            else -> wrong
        }
    }

    /** Whether the motorcycle is drawn in what was sent for the ground. */
    private fun isWorn() = ground.isNotEmpty() && both.all { it.color.distance(both[0].color) < DARK }

    private fun isWritten() =
        timeline.laterShots.mapNotNull { cast.motorcycle?.of(it.frame) }.let { all -> all.isNotEmpty() && all.all { it.isTintWritten } }

    /** Whether pictures that are equally long after the one before have one colour, whatever the time: made of dt instead of t. */
    private fun isOfStep(): Boolean {
        val alike = motorcycle.groupBy { it.moment.seconds }.values.filter { it.size > 1 }
        return alike.size > 1 && alike.all { spread(it) < SAME }
    }

    private fun light(): Axis {
        val own = staging.roles.own ?: return Axis.absent(CHECK, say("color.no-light")).lacking(say("lack.point"))
        val isPlain = motorcycle.lastOrNull()?.color?.let { it.distance(WHITE) < PLAIN || it.maxAbs() < DARK } ?: true
        val changes = motorcycle.isNotEmpty() && !isStill
        if (!changes && (own.track.changesColor || isPlain)) {
            // Sines on the light alone: what is missing is the motorcycle's colour, and costs there.
            val does = own.track.changesColor
            return Axis.right(CHECK, if (does) 0.0 else 1.0, say(if (does) "color.light-changes" else "color.light-still", own.name))
        }
        val worn = staging.roles.spot?.takeIf { it !== own && staging.isOverwritten(own) && staging.isOneColor(own, it) }
        if (worn != null) return Axis.right(CHECK, 0.0, say("color.light-worn", own.name, worn.name))
        return sameColor(own)
    }

    /** Whether [own] shines in the motorcycle's colour, times an intensity; or in that of a picture before. */
    private fun sameColor(own: PlacedLight): Axis {
        val errors = (0..MOST_LATE).mapNotNull { lag -> pairs(own, lag).takeIf { it.isNotEmpty() }?.let(::difference) }
        val error = errors.firstOrNull() ?: return Axis.open(CHECK, say("color.no-frame", own.name))
        val told = say("color.light-is", own.name, own.track.last.color, motorcycle.last().color)
        if (error <= DIFFERS) return Axis.right(CHECK, error, told)
        val lag = errors.indices.find { it > 0 && pairs(own, it).size > 1 && errors[it] <= DIFFERS }
        if (lag != null && isLate) return Axis.right(CHECK, 0.0, say("color.light-bound-late", own.name))
        val text = if (lag == null) told else say("color.light-lags", own.name, lag)
        return Axis.wrong(CHECK, error, text, Mistake.LIGHT_COLOR_DIFFERS, own.name)
    }

    /** The colours of the light with those that the motorcycle had [lag] pictures before. */
    private fun pairs(own: PlacedLight, lag: Int): List<Pair<Vector3dc, Vector3dc>> =
        if (lag == 0) {
            motorcycle.mapNotNull { tint -> own.track.at(tint.moment)?.let { tint.color to it.color } }
        } else {
            timeline.frames.drop(lag).zip(timeline.frames).mapNotNull { (now, before) ->
                val tint = cast.motorcycle?.of(before)?.tint?.takeIf { it.isFinite } ?: return@mapNotNull null
                own.track.at(now.moment)?.let { tint to it.color }
            }
        }

    /** A sine may be negative, and a colour below 0 is none, for the emission and the light alike. */
    private fun difference(pairs: List<Pair<Vector3dc, Vector3dc>>): Double =
        minOf(residual(pairs), residual(pairs.map { (tint, color) -> Vector3d(tint).max(Vector3d()) to Vector3d(color).max(Vector3d()) }))

    /** What is left of the colours when they are the tints times one intensity, relative to the largest; some time of lead is forgiven. */
    private fun residual(pairs: List<Pair<Vector3dc, Vector3dc>>): Double {
        val intensity = fit(pairs.map { (tint, color) -> Equation(listOf(tint), Vector3d(), color) })?.constants?.single() ?: return 1.0
        if (intensity <= 0) return 1.0
        val largest = pairs.maxOf { (tint, _) -> tint.length() }
        return pairs.maxOf { (tint, color) -> max(0.0, color.div(intensity, Vector3d()).distance(tint) - slack) } / largest
    }

    /** The fastest change of colour between frames that follow each other closely, for as long as one update and one picture may take. */
    private val slack: Double =
        motorcycle.zipWithNext().filter { (a, b) -> b.time > a.time && b.time - a.time <= CLOSE }.maxOfOrNull { (a, b) ->
            SLACK * a.color.distance(b.color) / (b.time - a.time)
        } ?: 0.0

    private fun spread(tints: List<Tint>): Double = tints.maxOfOrNull { it.color.distance(tints.first().color) } ?: 0.0

    private fun list(tints: List<Tint>) = tints.map { it.color }

    private companion object {
        val CHECK = Check.LIGHT_COLOR
        val WHITE: Vector3dc = Vector3d(1.0)
        val STANDING = setOf(Moment.SECOND, Moment.TIME_1, Moment.TIME_2, Moment.TIME_3, Moment.TIME_4)
        const val DARK = 1e-6
        const val PLAIN = 0.02
        const val STILL = 0.01

        /** A sixtieth of a second changes the slowest of the sheet's sines by 5 thousandths. */
        const val SAME = 1e-3
        const val CHANGE = 0.03
        const val DIFFERS = 0.03
        const val MOST_LATE = 2

        /** Seconds: one update may already be behind or ahead of the picture, and a picture of the next. */
        const val SLACK = 2.0 / 60
        const val CLOSE = 0.05
    }
}
