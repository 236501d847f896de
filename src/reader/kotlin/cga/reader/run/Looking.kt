package cga.reader.run

import cga.reader.shader.TextureCall

/** Asks samplers what is in [cells]. */
internal class Looking(private val cells: DoubleArray) {
    private val look = TextureLook()
    private val texel = DoubleArray(4)

    fun sample(call: TextureCall, sampler: Sampler, gradientX: DoubleArray, gradientY: DoubleArray): DoubleArray {
        look.coordinates = numbers(call.coordinates)
        look.isFetch = call.isFetch
        look.reference = number(call.reference)
        look.level = number(call.lod)
        look.bias = number(call.bias) ?: 0.0
        look.gradientX = if (call.gradientX.isEmpty()) gradientX else numbers(call.gradientX)
        look.gradientY = if (call.gradientY.isEmpty()) gradientY else numbers(call.gradientY)
        look.offset = IntArray(call.offset.size) { cells[call.offset[it]].toInt() }
        texel.fill(0.0)
        val result = if (call.isShadow) DoubleArray(1) else texel
        sampler.sample(look, result)
        return result
    }

    fun size(call: TextureCall, sampler: Sampler): DoubleArray {
        val extents = sampler.size(cells[call.coordinates[0]].toInt())
        return DoubleArray(call.results) { extents.getOrElse(it) { 1 }.toDouble() }
    }

    private fun number(cell: Int) = if (cell < 0) null else cells[cell]

    private fun numbers(of: IntArray) = DoubleArray(of.size) { cells[of[it]] }
}
