package cga.grading.scene

import cga.grading.capture.Moment
import org.joml.Vector3dc
import kotlin.math.abs

/** A light through all frames; frames in which its position or colour is no number are left out. */
internal class LightTrack(val name: String, private val states: Map<Moment, ObservedLight>) {
    private val inOrder = states.entries.sortedBy { it.key }.map { it.value }

    /** The last state: the one that is surely complete. */
    val last: ObservedLight = inOrder.last()

    /** The last cone, null for a point light. */
    val cone: ObservedCone? = inOrder.mapNotNull { it.spot }.lastOrNull()

    /** The largest colour value it ever has. */
    val brightest: Double = inOrder.maxOf { it.color.maxAbs() }

    /** Whether it ever gives light. */
    val shines: Boolean = brightest > DARK

    /** Whether its colour changes while nothing but time does. */
    val changesColor: Boolean =
        states.filterKeys { it != Moment.FIRST }.toSortedMap().values.map { it.color }.let { colors ->
            val largest = colors.maxOfOrNull { it.maxAbs() } ?: 0.0
            colors.zipWithNext().any { (a, b) -> a.distance(b) > CHANGE * largest }
        }

    fun at(moment: Moment): ObservedLight? = states[moment]

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
            return states.map { (name, its) -> LightTrack(name, its) }
        }
    }
}

internal fun Vector3dc.maxAbs(): Double = maxOf(abs(x()), abs(y()), abs(z()))
