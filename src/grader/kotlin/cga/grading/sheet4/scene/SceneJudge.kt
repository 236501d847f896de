package cga.grading.sheet4.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Measured
import cga.grading.findings.Mistake
import cga.grading.scene.Casting
import cga.grading.scene.GroundSpace
import cga.grading.scene.LightTrack
import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedFrame
import cga.grading.scene.ProgramFacts
import cga.grading.scene.Timeline
import org.joml.Vector3d

/**
 * Fits a model to what a scene does over the frames of the script, and judges it: whether lights ride along, what the mouse does, what time
 * does. Each axis of the model is one function over the same observations, judged with all others as they were found to be.
 *
 * What it needs of the observations:
 * - one [ObservedFrame] for each moment, in the script's order; those that are missing make checks unmeasured, never wrong;
 * - [ObservedFrame.view] as positions of vertices go through it. A view that cannot be inverted (all zero, as before the first bind) is
 *   fine and told as such. A view that never changes, as where only model-view matrices are sent, is replaced by the ground's;
 * - an object's [cga.grading.scene.ObservedObject.buffers] the same in every frame, and its model matrix apart from the view;
 * - a light's name the same in every frame and different from every other light's, also where it is black: a colour that grows from 0 with
 *   time is 0 in the first frame. A light that gives no light in any frame counts as missing;
 * - positions and directions in the view space of [ObservedFrame.view], relative errors below 1e-3; a direction of zero or NaN means that
 *   none arrived;
 * - the lights of ground and motorcycle, for the order of binding and drawing.
 *
 * A feature that is not there at all has an error of 1 in each of its checks; what could not be seen has none.
 */
public object SceneJudge {
    /** The checks that this judge writes. */
    public val CHECKS: Set<Check> =
        setOf(
            Check.POINT_LIGHT, Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.ORDER,
            Check.SPOT_LIGHT, Check.SPOT_LIGHT_CHILD, Check.SPOT_DIRECTION, Check.CONE,
            Check.ATTENUATION_POINT, Check.ATTENUATION_SPOT,
            Check.GROUND_COLOR, Check.MOTORCYCLE_COLOR, Check.LIGHT_COLOR,
            Check.ORBIT, Check.ORBIT_PIVOT, Check.ORBIT_HORIZON, Check.ORBIT_FACTOR, Check.ORBIT_START,
            Check.MORE_LIGHTS,
        )

    /**
     * The verdict on [frames].
     *
     * @param uniforms active uniforms of the programs, for telling what a misspelt name was meant to be; may be left out.
     * @param program what else is known of the programs.
     */
    public fun judge(
        frames: List<ObservedFrame>,
        events: List<CapturedEvent>,
        profile: SceneProfile = SceneProfile.SHEET,
        uniforms: Set<String> = emptySet(),
        program: ProgramFacts = ProgramFacts(),
    ): SceneVerdict {
        val settled = GroundSpace.settle(frames)
        val timeline = Timeline(settled, Casting(settled).cast())
        val roles = Roles.of(timeline, program)
        val lost = Lost(events, uniforms, program, LightTrack.all(settled).filter { it.shines })
        val staging = Staging(timeline, roles, profile, events, program)
        val axes = if (timeline.laterShots.isEmpty()) nothing(frames) else axes(staging)
        val refused = Refusal(events, program)
        val all = refused.judged(if (program.isReplaced) axes else lost.explained(axes))
        val notes = all.mapNotNull { it.note }.distinct()
        return SceneVerdict(all.checks(), all.mistakes(), notes, roles.unlit + lost.unlit, refused.isReplaced, roles.spot?.name)
    }

    private fun axes(staging: Staging): List<Axis> {
        val order = Order(staging)
        val cone = cone(staging)
        val aim = Aim(staging, isConeSent = cone?.mistake?.mistake != Mistake.CONE_NEVER_SENT)
        // The compiler drops what a shader declares and does not use.
        val isSent = staging.events.any { it.kind == EventKind.UNIFORM_ABSENT && staging.program.declares(it.text) }
        val notDriven = !staging.timeline.cast.driven && staging.timeline.frame(Moment.DRIVEN) != null
        return listOfNotNull(if (notDriven) Axis.note(say("scene.not-driven")) else null) +
            Presence(staging, aim).axes() + Places(staging).axes() + aim.axes() + listOfNotNull(cone) +
            Fading(staging).axes() + Colors(staging, isSent, order.isLate).axes() + Orbit(staging).axes() + Further(staging).axes() +
            order.axis()
    }

    private fun cone(staging: Staging): Axis? {
        val spot = staging.roles.spot ?: return null
        if (!spot.isSpot && spot.name in staging.program.strange) {
            // Something of the headlight is to be seen, and what is wrong with it has no name.
            return Axis.wrong(Check.CONE, 1.0, say("spot.uneven", spot.name), Mistake.UNKNOWN, spot.name, explains = UNTOLD)
        }
        // A light that is a spotlight only by what it is meant to be.
        return Cone.axis(spot.track.cone ?: ObservedCone(Vector3d(), Double.NaN, Double.NaN), spot.name)
    }

    /** What the shaders make of a cone that cannot be told. */
    private val UNTOLD = setOf(Check.CONE_SPECULAR, Check.MORE_LIGHTS_SHADING)

    private fun nothing(frames: List<ObservedFrame>): List<Axis> {
        val text = say(if (frames.isEmpty()) "scene.no-frame" else "scene.no-motorcycle")
        return CHECKS.map { Axis.open(it, text) } + Axis.note(say("scene.not-judged", text))
    }
}

/** Shaders that the driver refused: what stands in for them shows nothing of the shading, and of the rest what was understood. */
private class Refusal(events: List<CapturedEvent>, private val program: ProgramFacts) {
    private val failed = events.firstOrNull { it.kind == EventKind.SHADER_FAILED || it.kind == EventKind.LINK_FAILED }?.text
    private val dialect = events.firstOrNull { it.kind == EventKind.SHADER_DIALECT }?.text

    /** Whether stand-ins took the place of shaders. */
    val isReplaced: Boolean = failed != null && program.isReplaced

    /** [axes] without what cannot be seen, and with the refusal. */
    fun judged(axes: List<Axis>): List<Axis> {
        val refusal = failed?.let { Axis.named(Axis.found(Mistake.SHADER_REFUSED, telling(it)), null) }
        // Shaders that only needed other words: all that they do can be seen.
        val words = dialect?.let { Axis.wrong(Check.ORDER, 1.0, say("event.dialect"), Mistake.GLSL_DRIVER, telling(it)) }
        val hidden = if (isReplaced) axes.checks().filter(::isHidden).map { it.check }.toSet() else emptySet()
        val unseen = if (isReplaced) Check.entries - SceneJudge.CHECKS + hidden else emptyList()
        val seen = axes.filter { it.measured?.check !in unseen && it.mistake?.mistake?.check !in unseen }
        return seen + hidden.map { Axis.open(it, say("event.refused")) } + listOfNotNull(refusal, words)
    }

    /** Whether a check asks for more than the numbers tell that were sent to a shader that was refused. */
    private fun isHidden(measured: Measured) =
        measured.check !in Orbit.CHECKS &&
            (measured.check == Check.CONE || !program.isRead || (!program.isReadWhole && (measured.error ?: 0.0) > SOUND))

    /** The stage and the first error. */
    private fun telling(log: String): String {
        val lines = log.lines().filter { it.isNotBlank() }
        val telling = listOfNotNull(lines.firstOrNull(), lines.find { ERROR.containsMatchIn(it) } ?: lines.getOrNull(1))
        return telling.distinct().joinToString(": ") { it.trim() }
    }

    private companion object {
        /** An error that every tolerance of the rubric allows. */
        const val SOUND = 0.01
        val ERROR = Regex("\\berror\\b", RegexOption.IGNORE_CASE)
    }
}
