package cga.inspect.knob

import org.joml.Vector3f
import org.joml.Vector3fc

/**
 * A number of the scene that the panel can turn.
 *
 * @param name what the panel calls it.
 * @param min the slider's ends, [max] the other; both are values that the scene accepts.
 */
internal class Knob(
    val name: String,
    val min: Float,
    val max: Float,
    private val get: () -> Float,
    private val set: (Float) -> Unit,
) {
    private var start = get()

    var value: Float
        get() = get.invoke()
        set(value) {
            set.invoke(value)
        }

    fun reset() {
        if (value != start) value = start
    }

    /** From now on [reset] goes back to the present value. */
    fun remember() {
        start = value
    }
}

/** Knobs that belong together, under a [title]. */
internal class KnobGroup(
    val title: String,
    val knobs: List<Knob>,
)

/** Three knobs, called [x], [y] and [z], for the components of a vector. */
internal fun axes(
    x: String,
    y: String,
    z: String,
    min: Float,
    max: Float,
    get: () -> Vector3fc,
    set: (Vector3fc) -> Unit,
): List<Knob> =
    listOf(x, y, z).mapIndexed { i, name ->
        Knob(name, min, max, { get()[i] }) { value -> set(Vector3f(get()).setComponent(i, value)) }
    }
