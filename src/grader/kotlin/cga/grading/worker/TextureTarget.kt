package cga.grading.worker

import org.lwjgl.opengl.GL33C.*

/** Where a texture is bound. @param sides what its pictures are uploaded to. */
internal enum class TextureTarget(
    val bound: Int,
    val binding: Int,
    val sides: List<Int>,
) {
    FLAT(GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, listOf(GL_TEXTURE_2D)),
    CUBE(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP, List(6) { GL_TEXTURE_CUBE_MAP_POSITIVE_X + it }),
    ;

    companion object {
        /** What a sampler of [type] reads, null for what a capture cannot hold. */
        fun ofSampler(type: Int): TextureTarget? =
            when (type) {
                GL_SAMPLER_2D -> FLAT
                GL_SAMPLER_CUBE -> CUBE
                else -> null
            }

        /** What a call about [target] writes to. */
        fun written(target: Int): TextureTarget = if (target == CUBE.bound || target in CUBE.sides) CUBE else FLAT
    }
}
