package cga.exercise.engine

class Tick(val dt: Float, val t: Float)
class Frame(val t: Float)
class MouseMoved(val dx: Double, val dy: Double)

/** Who posts an event does not know who listens. */
class EventBus {
    private val listeners = LinkedHashMap<Class<*>, MutableList<(Any) -> Unit>>()

    fun <T : Any> listen(type: Class<T>, listener: (T) -> Unit) {
        listeners.getOrPut(type) { ArrayList() }.add { listener(type.cast(it)) }
    }

    inline fun <reified T : Any> on(noinline listener: (T) -> Unit) = listen(T::class.java, listener)

    fun post(event: Any) {
        listeners[event.javaClass]?.forEach { it(event) }
    }
}
