package cga.measure.golden

import cga.exercise.game.Step
import cga.framework.SpecularModel

/** Every picture of which there is a golden. */
public object GoldenCases {
    // Pixels of mouse for a quarter turn of the camera, at 0.002 rad a pixel.
    private const val QUARTER = Math.PI / 2 / 0.002

    private val steps =
        listOf(
            GoldenCase("step-4.1", "emission alone; the grid's minification towards the horizon", Step.EMISSION),
            GoldenCase("step-4.2", "a white point light without attenuation, Phong", Step.POINT_LIGHT),
            GoldenCase("step-4.3", "the spotlight's cone without attenuation", Step.SPOT_LIGHT),
            GoldenCase("step-4.3.4", "attenuation of both lights", Step.ATTENUATION),
            GoldenCase("step-4.4", "green ground, the motorcycle and its light in one colour", Step.COLOR),
            GoldenCase("step-4.5", "as 4.4, with the camera turned a little", Step.ORBIT, mouse = 200.0),
            GoldenCase("step-4.6", "corner lights, Phong", Step.MORE_LIGHTS),
            GoldenCase("step-4.7", "the finished sheet: Blinn-Phong", Step.BLINN_PHONG),
        )

    // Red, green and blue are |sin| of t, t/2 and t/3.
    private val times =
        listOf(
            GoldenCase("time-black", "t = 0: the motorcycle glows and lights not at all", Step.COLOR, t = 0.0),
            GoldenCase("time-red", "red, the others dim", Step.COLOR, t = 18.1),
            GoldenCase("time-yellow", "red and green, little blue", Step.COLOR, t = 10.5),
            GoldenCase("time-cyan", "green and blue, no red", Step.BLINN_PHONG, t = 3.15),
            GoldenCase("time-blue", "blue, the others dim", Step.BLINN_PHONG, t = 6.0),
            GoldenCase("time-white", "all three channels near 1", Step.BLINN_PHONG, t = 2.2),
            GoldenCase("time-late", "more than an hour, of which a float would have lost the fractions", Step.BLINN_PHONG, t = 5000.3),
        )

    // From (0, 0) towards −z, 4 units a second; turning, 1.5 rad a second. The corner lights stand at ±16 and the ground ends at ±22.4.
    private val drives =
        listOf(
            GoldenCase("drive-red", "at the red corner light, Phong highlights", Step.MORE_LIGHTS, t = 6.0, drive = "WA 0.52, W 4.4"),
            GoldenCase("drive-blue", "at the blue corner light", Step.BLINN_PHONG, t = 6.0, drive = "WD 0.52, W 4.4"),
            GoldenCase("drive-amber", "turned about, before the amber corner light", Step.BLINN_PHONG, t = 7.0, drive = "WA 1.57, W 3.6"),
            GoldenCase("drive-pink", "backwards under the pink corner light", Step.BLINN_PHONG, t = 8.0, drive = "SD 0.52, S 4"),
            GoldenCase(
                "drive-edge",
                "backwards over the edge: the ground ends before the camera",
                Step.BLINN_PHONG,
                t = 6.0,
                drive = "S 5.4",
            ),
            GoldenCase(
                "drive-spot", "the cone turned with the motorcycle", Step.ORBIT, t = 2.0, drive = "WA 1, W 0.5",
                mouse =
                    -0.6 * QUARTER,
            ),
        )

    private val cameras =
        listOf(
            GoldenCase("orbit-left", "the motorcycle's left side", Step.BLINN_PHONG, mouse = -QUARTER),
            GoldenCase("orbit-right", "its right side, Phong highlights", Step.MORE_LIGHTS, mouse = QUARTER),
            GoldenCase("orbit-front", "its front", Step.BLINN_PHONG, mouse = 2 * QUARTER),
            GoldenCase("orbit-slant", "obliquely from the front, without corner lights", Step.ORBIT, mouse = 1.4 * QUARTER),
        )

    private val switches =
        listOf(
            GoldenCase("switch-phong", "4.7 with Phong", Step.BLINN_PHONG, mouse = -0.5 * QUARTER, specular = SpecularModel.PHONG),
            GoldenCase("switch-blinn", "4.3 with Blinn-Phong", Step.SPOT_LIGHT, specular = SpecularModel.BLINN_PHONG),
            GoldenCase("switch-gamma", "encoded for gamma 2.2", Step.BLINN_PHONG, gamma = 2.2f),
            GoldenCase("switch-samples", "4 samples a pixel", Step.BLINN_PHONG, samples = 4),
            GoldenCase("switch-float", "unclamped floats", Step.BLINN_PHONG, float = true),
            GoldenCase("switch-orbit", "camera turned by more than a whole turn", Step.BLINN_PHONG, mouse = 4.6 * QUARTER),
            GoldenCase(
                "switch-drive",
                "forwards, left, backwards, right, rest",
                Step.BLINN_PHONG,
                t = 5.0,
                drive = "W 1, WA 0.5, S 0.4, WD 1, 0.5",
            ),
        )

    /** All of them, in the order in which they are rendered and listed. */
    public val all: List<GoldenCase> = steps + times + drives + cameras + switches
}
