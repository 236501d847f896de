package cga.inspect.doctor

import cga.framework.Frame
import cga.framework.image.FloatImage

/**
 * An active uniform of the program that drew, and what it held after drawing.
 *
 * @param type OpenGL's constant (`GL_FLOAT_VEC3`, …).
 * @param numbers its value; matrices by columns, truth values and texture units as numbers.
 */
internal class UniformValue(
    val name: String,
    val type: Int,
    val numbers: FloatArray,
) {
    val isZero: Boolean get() = numbers.all { it == 0f }
    val isFinite: Boolean get() = numbers.all(Float::isFinite)
}

/**
 * A sampler of the program.
 *
 * @param problem why the texture at its unit reads as black, or null.
 */
internal class SamplerState(
    val name: String,
    val unit: Int,
    val problem: String?,
)

/**
 * What was found by looking at a scene after it drew a picture.
 *
 * @param program the program in use then, 0 for none.
 * @param sent names of the uniforms that the scene set.
 * @param warnings what was said of uniforms that the shaders do not have, with the nearest name.
 * @param frame the scene's geometry, lights and camera.
 * @param picture unclamped.
 * @param withoutLights the same with all lights off.
 */
internal class Evidence(
    val program: Int,
    val uniforms: List<UniformValue>,
    val samplers: List<SamplerState>,
    val sent: Set<String>,
    val warnings: List<String>,
    val frame: Frame,
    val picture: FloatImage,
    val withoutLights: FloatImage,
) {
    /** Whether nothing in the picture can be told from black. */
    val isBlack: Boolean get() = channels(picture).all { it < VISIBLE }

    /** Whether the lights make no visible difference. */
    val isUnlit: Boolean get() = channels(picture).zip(channels(withoutLights)).all { (a, b) -> kotlin.math.abs(a - b) < VISIBLE }

    /** Pixels that are not numbers. */
    val notFinite: Int get() = (picture.rgba.indices step 4).count { i -> (0..2).any { !picture.rgba[i + it].isFinite() } }

    val hasLights: Boolean get() = frame.lights.isNotEmpty()

    // NaN is shown as black.
    private fun channels(image: FloatImage) =
        image.rgba.indices.asSequence().filter { it % 4 != 3 }.map { image.rgba[it].let { x -> if (x.isNaN()) 0f else x } }

    private companion object {
        /** Half a step of 255 more than black. */
        const val VISIBLE = 1.5f / 255
    }
}
