package cga.grading.scene

import cga.grading.capture.Moment
import org.joml.Vector3dc
import kotlin.math.abs

/** A light through all frames; frames in which its position or colour is no number are left out. */
internal class LightTrack(
    val name: String,
    private val states: Map<Moment, ObservedLight>,
) {
    fun at(moment: Moment): ObservedLight? = states[moment]

    /** The last state: the one that is surely complete. */
    val last: ObservedLight = states.entries.maxBy { it.key.ordinal }.value

    /** The last cone, null for a point light. */
    val cone: ObservedCone? = states.entries.sortedBy { it.key.ordinal }.mapNotNull { it.value.spot }.lastOrNull()
    val isSpot: Boolean get() = cone != null

    /** Whether it hangs on the camera: fixed to it, though what is sent went through the view matrix. */
    val isOnCamera: Boolean get() = placed.place == Place.CONSTANT && last.isViewed && placed.holding.none { it.right }

    /** Whether it ever gives light. */
    val shines: Boolean = states.values.any { it.color.maxAbs() > DARK }

    /** Whether its colour changes while the motorcycle stands. */
    val changesColor: Boolean

    /** The largest colour value it ever has. */
    val brightest: Double = states.values.maxOf { it.color.maxAbs() }

    init {
        val colors = Moment.entries.filter { it != Moment.FIRST }.mapNotNull { states[it]?.color }
        val largest = colors.maxOfOrNull { it.maxAbs() } ?: 0.0
        changesColor = colors.zipWithNext().any { (a, b) -> a.distance(b) > CHANGE * largest }
    }

    /** The best of the hypotheses, those first that are right. */
    var placed: Placed = Placed.UNKNOWN

    /** Whether it is known to move with the motorcycle. */
    val rides: Boolean get() = placed.place?.rides == true

    companion object {
        const val DARK = 1e-6
        private const val CHANGE = 0.02

        /** All lights of all [frames], in the order in which they first appear; [of] a frame others than those that are drawn with. */
        fun all(frames: List<ObservedFrame>, of: (ObservedFrame) -> List<ObservedLight> = ObservedFrame::lights): List<LightTrack> {
            val states = LinkedHashMap<String, LinkedHashMap<Moment, ObservedLight>>()
            for (frame in frames) {
                for (light in of(frame)) {
                    if (light.position.isFinite && light.color.isFinite) {
                        states.getOrPut(light.name) { LinkedHashMap() }.putIfAbsent(frame.moment, light)
                    }
                }
            }
            return states.map { (name, itsStates) -> LightTrack(name, itsStates) }
        }
    }
}

internal fun Vector3dc.maxAbs(): Double = maxOf(abs(x()), abs(y()), abs(z()))
