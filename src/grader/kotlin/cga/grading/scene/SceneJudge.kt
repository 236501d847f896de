package cga.grading.scene

import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.capture.Moment
import cga.grading.findings.Check
import cga.grading.findings.Mistake
import org.joml.Vector3d

/**
 * What is known of a submission's programs beside what they draw.
 *
 * @param unset active uniforms, samplers apart, that are 0 in every draw; null where nobody looked.
 * @param idle whole numbers and truth values that are 0 in every draw: a count of lights that never arrived, or a choice.
 * @param declares whether the shaders declare a uniform of that name: then it is spelt right, even if the compiler dropped it.
 * @param drawn the moments at which anything was drawn at all.
 * @param canCone whether the shaders could limit a light to a cone, while none has one.
 * @param deadly uniforms that nobody sends and that leave no number of the picture: something is divided by them.
 * @param lent names of lights in whose colour another one shines too, where none has a cone; [strange] of those that shine unevenly, and in
 * no cone around a direction.
 * @param isReplaced whether all that is drawn is drawn by stand-ins for shaders that the driver refused.
 * @param isRead whether the sheet's own lighting could take their place, so that all but the shading can be seen; [isReadWhole] whether it
 * is clear what each number that was sent means, so that what cannot be seen is not there.
 */
public class ProgramFacts(
    public val unset: Set<String>? = null,
    public val declares: (String) -> Boolean = { false },
    public val drawn: Set<Moment> = emptySet(),
    public val isReplaced: Boolean = false,
    public val isRead: Boolean = false,
    public val isReadWhole: Boolean = false,
    public val canCone: Boolean = false,
    public val deadly: Set<String> = emptySet(),
    public val idle: Set<String> = emptySet(),
    public val lent: Set<String> = emptySet(),
    public val strange: Set<String> = emptySet(),
)

/**
 * Judges what a scene does over the frames of the script: whether lights ride along, what the mouse does, what time does.
 *
 * What it needs of the observations:
 * - one [ObservedFrame] for each moment, in the script's order; those that are missing make checks unmeasured, never wrong;
 * - [ObservedFrame.view] as positions of vertices go through it. A view that cannot be inverted (all zero, as before the first bind) is
 *   fine and told as such. A view that never changes, as where only model-view matrices are sent, is replaced by the ground's;
 * - an object's [ObservedObject.buffers] the same in every frame, and its model matrix apart from the view;
 * - a light's [ObservedLight.name] the same in every frame and different from every other light's;
 * - lights also where they are black: a colour that grows from 0 with time is 0 in the first frame. A light that gives no light in any
 *   frame counts as missing;
 * - positions and directions in the view space of [ObservedFrame.view], relative errors below 1e-3; a direction of zero or NaN means that
 *   none arrived;
 * - [ObservedObject.lights] of ground and motorcycle, for the order of binding and drawing.
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
        val book = Notebook()
        val settled = GroundSpace.settle(frames)
        val timeline = Timeline(settled, Casting(settled).cast())
        if (timeline.laterShots.isEmpty()) nothing(book, frames) else judge(timeline, events, profile, program, book)
        val lights = LightTrack.all(settled).filter { it.shines }
        EventJudge(events, uniforms, program, lights, book).judge()
        return book.verdict()
    }

    private fun judge(
        timeline: Timeline,
        events: List<CapturedEvent>,
        profile: SceneProfile,
        program: ProgramFacts,
        book: Notebook,
    ) {
        if (!timeline.cast.driven && timeline.frame(Moment.DRIVEN) != null) {
            book.note("The motorcycle cannot be driven with W, A, S and D, nor with the arrow keys: what it is was guessed.")
        }
        val roles = LightRoles.of(timeline, program.canCone)
        book.unlit = roles.unlit
        book.spot = roles.spot?.name
        LightJudge(timeline, roles, program, events, book).judge()
        PositionJudge(timeline, roles, events, book).judge()
        DirectionJudge(timeline, roles, book).judge()
        cone(roles, book)
        AttenuationJudge(timeline, roles, profile, events, book).judge()
        ColorJudge(timeline, roles, events.any { it.kind == EventKind.UNIFORM_ABSENT }, book).judge()
        OrbitJudge(timeline, profile, book).judge()
        ParentOrder(timeline, roles, book).judge()
        MoreLightsJudge(timeline, roles, book).judge()
        DriftJudge(timeline, roles, book).judge()
        OrderJudge(timeline, roles, events, program.drawn, book).judge()
    }

    private fun cone(
        roles: LightRoles,
        book: Notebook,
    ) {
        val spot = roles.spot ?: return
        // A light that is a spotlight only by what it is meant to be.
        val cone = spot.cone ?: ObservedCone(Vector3d(), Double.NaN, Double.NaN)
        val (measured, found) = ConeValues.judge(cone, spot.name)
        book.measured(Check.CONE, measured.error, measured.text)
        if (found != null) {
            book.found(found.mistake, found.fit, found.difference, found.where, found.alternatives, found.explains)
        }
        // The overload of bind that knows no cone sends no direction either.
        if (found?.mistake == Mistake.CONE_NEVER_SENT) {
            if (book.missing.any { it.startsWith("the direction") }) {
                book.measured(Check.SPOT_DIRECTION, 0.0, "Neither the cone nor the direction arrives: that costs at the cone.")
            }
            book.lacks(
                "the cone of ${spot.name}",
                setOf(Check.CONE, Check.SPOT_DIRECTION, Check.CONE_SPECULAR),
                setOf(Mistake.CONE_NEVER_SENT),
            )
        }
    }

    private fun nothing(
        book: Notebook,
        frames: List<ObservedFrame>,
    ) {
        val text = if (frames.isEmpty()) "No frame is understood." else "No frame has a motorcycle and a view to see it with."
        CHECKS.forEach { book.measured(it, null, text) }
        book.note("Nothing of the scene could be judged. $text")
    }
}
