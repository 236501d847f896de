package cga.imaging.golden

import cga.imaging.Picture

/**
 * Where a picture comes from.
 *
 * @param made how it was asked for, by name: size, t, step, …
 * @param inputs hashes of all that it was made of, by name: shaders, assets, parts of the scene.
 */
public class Origin(
    public val machine: Machine,
    public val made: Map<String, String>,
    public val inputs: Map<String, String>,
) {
    /** What of this is not as in [approved]: names of inputs, and for how the picture was asked for both values. */
    internal fun changesSince(approved: Origin): List<String> =
        (inputs.keys + approved.inputs.keys).filter { inputs[it] != approved.inputs[it] } +
            (made.keys + approved.made.keys)
                .filter { made[it] != approved.made[it] }
                .map { "$it ${approved.made[it] ?: "not given"} → ${made[it] ?: "not given"}" }
}

/** A picture just made, and its origin. */
public class Rendered(
    public val picture: Picture,
    public val origin: Origin,
)
