package cga.framework

/** The mouse cursor in screen coordinates: pixels from the window's left and top edge. */
public class MousePosition(
    public var xpos: Double,
    public var ypos: Double,
)
