package cga.exercise.util

import org.joml.Vector3f
import kotlin.math.max
import kotlin.math.min

/** #rrggbb to linear-ish 0..1, times a strength because lights want more than 1 */
fun hex(rgb: Int, strength: Float = 1.0f) = Vector3f(
    (rgb shr 16 and 0xff) / 255.0f,
    (rgb shr 8 and 0xff) / 255.0f,
    (rgb and 0xff) / 255.0f
).mul(strength)

/** hue in degrees 0..360, saturation and value 0..1 */
fun Vector3f.setHsv(hue: Float, saturation: Float, value: Float): Vector3f {
    fun channel(n: Float): Float {
        val k = (n + hue / 60.0f) % 6.0f
        return value * (1.0f - saturation * max(0.0f, min(1.0f, min(k, 4.0f - k))))
    }
    return set(channel(5.0f), channel(3.0f), channel(1.0f))
}
