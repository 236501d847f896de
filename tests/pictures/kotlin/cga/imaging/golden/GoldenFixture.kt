package cga.imaging.golden

import cga.framework.image.ImageData
import cga.imaging.BytePicture
import cga.imaging.Picture

/** A machine that draws goldens. */
internal val LLVMPIPE = Machine("llvmpipe (LLVM 15.0.6, 256 bits)", "Mesa 22.3.6", listOf("avx", "ssse3"), emptyMap())

/** A picture of one grey, as if it had just been drawn. */
internal fun drawn(
    grey: Int,
    machine: Machine = LLVMPIPE,
    made: Map<String, String> = mapOf("t" to "5.3"),
    inputs: Map<String, String> = mapOf("shaders/scene.frag" to "1a", "scene lights" to "2b"),
    picture: Picture = grey(grey),
): Rendered = Rendered(picture, Origin(machine, made, inputs))

internal fun grey(
    value: Int,
    width: Int = 8,
): BytePicture = BytePicture.opaque(ImageData(width, 8, ByteArray(4 * width * 8) { value.toByte() }))
