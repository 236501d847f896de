package cga.grading.analysis

import cga.framework.image.ImageData
import cga.grading.capture.CapturedDraw
import cga.grading.capture.UniformValue
import cga.grading.replay.Change
import cga.grading.study.Materials
import org.lwjgl.opengl.GL33C.GL_SAMPLER_2D

/** A frame with all light but that of [light] taken away: the colours of [lights] black, the emission's texture and ambient light, too. */
internal class LightAlone(
    private val materials: Materials,
    private val light: String,
    private val lights: Set<String>,
) : Change() {
    override fun numbers(
        step: Int,
        draw: CapturedDraw,
        uniform: UniformValue,
    ): FloatArray {
        val isOff = (uniform.name in lights && uniform.name != light) || uniform.name == materials.ambientUniform(draw.program)
        return if (isOff) FloatArray(uniform.numbers.size) else uniform.numbers
    }

    override fun texture(
        step: Int,
        draw: CapturedDraw,
        unit: Int,
    ): ImageData? = if (unit == emissionUnit(draw)) BLACK else null

    /** The unit that only the emission is read from. */
    private fun emissionUnit(draw: CapturedDraw): Int? {
        val sampler = materials.emissionSampler(draw.program) ?: return null
        val units = draw.uniforms.filter { it.type == GL_SAMPLER_2D || it.name == sampler }.associate { it.name to it.numbers[0].toInt() }
        val unit = units[sampler] ?: return null
        return unit.takeIf { units.values.count { it == unit } == 1 }
    }

    private companion object {
        val BLACK = ImageData.ofColor(0f, 0f, 0f)
    }
}
