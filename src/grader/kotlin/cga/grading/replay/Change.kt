package cga.grading.replay

import cga.framework.image.ImageData
import cga.grading.capture.CapturedDraw
import cga.grading.capture.CapturedProgram
import cga.grading.capture.UniformValue

/**
 * How a frame is to be drawn differently from how it was captured. By itself it changes nothing: override what shall differ.
 *
 * Programs and pictures are compared by identity: hand out the same object to have it compiled or uploaded once.
 */
public open class Change {
    /** Whether step number [step] of the frame, [draw], is drawn at all. */
    public open fun isDrawn(
        step: Int,
        draw: CapturedDraw,
    ): Boolean = true

    /** The numbers that [uniform] gets in [draw]; as many as it has. */
    public open fun numbers(
        step: Int,
        draw: CapturedDraw,
        uniform: UniformValue,
    ): FloatArray = uniform.numbers

    /** The program that draws in the place of [captured]; uniforms that it does not have are passed over. */
    public open fun program(
        step: Int,
        draw: CapturedDraw,
        captured: CapturedProgram,
    ): CapturedProgram = captured

    /**
     * A picture in the place of the texture that [draw] samples at [unit], null for the captured one. It repeats and is filtered linearly,
     * without mipmaps.
     */
    public open fun texture(
        step: Int,
        draw: CapturedDraw,
        unit: Int,
    ): ImageData? = null

    public companion object {
        /** The frame as it was. */
        public val NONE: Change = Change()

        /** Uniforms get other numbers wherever they occur, by name. */
        public fun uniforms(numbers: Map<String, FloatArray>): Change =
            object : Change() {
                override fun numbers(
                    step: Int,
                    draw: CapturedDraw,
                    uniform: UniformValue,
                ): FloatArray = numbers[uniform.name] ?: uniform.numbers
            }
    }
}
