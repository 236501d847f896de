package cga.inspect

import org.lwjgl.glfw.GLFW.*

/**
 * What the mouse means. With the cursor hidden every movement turns the camera, or, with the left button held down, moves the divider.
 * With the panel open the right button turns, held down, and the left one drags the divider or picks a pixel.
 */
internal class Pointer {
    private var lastX = Double.NaN
    private var isTurning = false

    /** Whether the divider follows the mouse. */
    var isDividing: Boolean = false
        private set

    /** Where the camera's mouse is: pixels since the start, movements that turn nothing left out. */
    var orbitX: Double = 0.0
        private set

    /** How far the last [move] went. */
    var movement: Double = 0.0
        private set

    /** The mouse is at [x]. The first position after [pause] only says where it starts. */
    fun move(
        x: Double,
        isOpen: Boolean,
    ) {
        movement = if (lastX.isNaN()) 0.0 else x - lastX
        if (isTurning || !(isOpen || isDividing)) orbitX += movement
        lastX = x
    }

    /** The cursor was shown or hidden: where it is next is no movement. */
    fun pause() {
        lastX = Double.NaN
        isTurning = false
        isDividing = false
    }

    /** A button over the scene went down, where the left one takes the divider ([isOnDivider]) or not; answers whether it picks a pixel. */
    fun press(
        button: Int,
        isOnDivider: Boolean,
    ): Boolean {
        if (button == GLFW_MOUSE_BUTTON_RIGHT) isTurning = true
        if (button != GLFW_MOUSE_BUTTON_LEFT) return false
        isDividing = isOnDivider
        return !isOnDivider
    }

    fun release(button: Int) {
        if (button == GLFW_MOUSE_BUTTON_RIGHT) isTurning = false
        if (button == GLFW_MOUSE_BUTTON_LEFT) isDividing = false
    }
}
