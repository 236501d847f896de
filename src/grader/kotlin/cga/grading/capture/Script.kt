package cga.grading.capture

/**
 * A moment of the script that every submission is played by.
 *
 * @param seconds how long the game is updated since the moment before.
 * @param keys what is held down meanwhile.
 * @param mouse where the cursor is moved to before that, in screen coordinates; null: it stays.
 * @param drawn whether the picture is drawn, or only its calls noted.
 */
public enum class Moment(
    public val seconds: Double,
    public val keys: Set<Key> = emptySet(),
    public val mouse: Cursor? = null,
    public val drawn: Boolean = false,
) {
    /** The very first frame: state that is set too late is missing here. */
    FIRST(0.0, drawn = true),

    /** The frame after it, with nothing else changed but the time. */
    SECOND(1.0 / 60),
    TIME_1(0.7),
    TIME_2(1.3),
    TIME_3(1.9),
    TIME_4(1.4, drawn = true),
    DRIVEN(1.0, setOf(Key.FORWARD)),
    STEERED(1.0, setOf(Key.FORWARD, Key.LEFT)),

    /** The first mouse event of all: a camera that jumps here took the difference to 0. */
    MOUSE_FIRST(1.0 / 60, mouse = Cursor(640.0, 360.0)),
    MOUSE_RIGHT(1.0 / 60, mouse = Cursor(740.0, 360.0)),
    MOUSE_DOWN(1.0 / 60, mouse = Cursor(740.0, 460.0)),
    ALT_HELD(1.0 / 60, setOf(Key.LEFT_ALT)),
    ALT_RIGHT(1.0 / 60, setOf(Key.LEFT_ALT), Cursor(840.0, 460.0)),
    ALT_DOWN(1.0 / 60, setOf(Key.LEFT_ALT), Cursor(840.0, 560.0)),
    ALT_RELEASED(1.0 / 60),
    MOUSE_FAR(1.0 / 60, mouse = Cursor(1240.0, 560.0), drawn = true),
    MOUSE_DRIVEN(0.5, setOf(Key.FORWARD, Key.RIGHT)),
}

/** The keys of the sheet. */
public enum class Key { FORWARD, BACK, LEFT, RIGHT, LEFT_ALT }

/** A position of the cursor in screen coordinates, from the top left. */
public class Cursor(
    public val x: Double,
    public val y: Double,
)
