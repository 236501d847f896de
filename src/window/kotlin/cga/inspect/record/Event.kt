package cga.inspect.record

/** Something that happened to the scene after so many of its updates. */
public sealed interface Event {
    /** From the next update on exactly the [keys] (letters of W, A, S, D) are held down. */
    public data class Hold(val keys: String) : Event

    /** The mouse is at [x]. */
    public data class Mouse(val x: Double) : Event

    /** The key with this GLFW number was pressed. */
    public data class Press(val key: Int) : Event

    /** The number called [name] of the panel, or of what is looked at, is [value] now. */
    public data class Turn(
        val name: String,
        val value: Float,
    ) : Event

    /** Every number of the panel went back to what it was at the start. */
    public data object Reset : Event

    /** A screenshot was taken. */
    public data object Picture : Event
}
