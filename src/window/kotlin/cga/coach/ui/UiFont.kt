package cga.coach.ui

import org.lwjgl.nuklear.NkAllocator
import org.lwjgl.nuklear.NkDrawNullTexture
import org.lwjgl.nuklear.NkFont
import org.lwjgl.nuklear.NkFontAtlas
import org.lwjgl.nuklear.NkFontConfig
import org.lwjgl.nuklear.NkHandle
import org.lwjgl.nuklear.NkUserFont
import org.lwjgl.nuklear.Nuklear.*
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil
import java.nio.ByteBuffer

/**
 * The letters of the panel, drawn once into a texture: DejaVu Sans, Latin and Greek.
 *
 * @param pixelRatio framebuffer pixels per unit of the window: the letters are drawn that much finer, and take the same room.
 */
internal class UiFont(
    allocator: NkAllocator,
    private val pixelRatio: Float,
) : AutoCloseable {
    private val atlas = NkFontAtlas.calloc()
    private val ranges = MemoryUtil.memAllocInt(RANGES.size).put(RANGES).flip()
    private val font: NkFont
    val texture: Int = glGenTextures()

    /** A texel that is white, for what is drawn without letters. */
    val white: NkDrawNullTexture = NkDrawNullTexture.calloc()

    val handle: NkUserFont get() = font.handle()

    init {
        nk_font_atlas_init(atlas, allocator)
        nk_font_atlas_begin(atlas)
        font = add()
        MemoryStack.stackPush().use { stack ->
            val width = stack.mallocInt(1)
            val height = stack.mallocInt(1)
            val pixels = checkNotNull(nk_font_atlas_bake(atlas, width, height, NK_FONT_ATLAS_RGBA32)) { "the font cannot be drawn" }
            upload(pixels, width[0], height[0])
            nk_font_atlas_end(atlas, NkHandle.malloc(stack).id(texture), white)
        }
        nk_font_atlas_cleanup(atlas)
        handle.height(SIZE)
    }

    private fun add(): NkFont =
        MemoryStack.stackPush().use { stack ->
            val bytes = UiFiles.read(FILE)
            val file = MemoryUtil.memAlloc(bytes.size).put(bytes).flip()
            val config = nk_font_config(SIZE * pixelRatio, NkFontConfig.malloc(stack)).range(ranges)
            try {
                checkNotNull(nk_font_atlas_add_from_memory(atlas, file, SIZE * pixelRatio, config)) { "$FILE is no font" }
            } finally {
                MemoryUtil.memFree(file)
            }
        }

    /** How wide [text] is on one line, in window units. */
    fun width(text: String): Float {
        var sum = 0f
        for (letter in text) sum += nk_font_find_glyph(font, letter.code)?.xadvance() ?: 0f
        return sum / pixelRatio
    }

    private fun upload(
        pixels: ByteBuffer,
        width: Int,
        height: Int,
    ) {
        glBindTexture(GL_TEXTURE_2D, texture)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels)
    }

    override fun close() {
        glDeleteTextures(texture)
        nk_font_atlas_clear(atlas)
        atlas.free()
        white.free()
        MemoryUtil.memFree(ranges)
    }

    companion object {
        private const val FILE = "DejaVuSans.ttf"

        /** Height of a line in window units. */
        const val SIZE: Float = 15f

        /** First and last code points of what is used: Latin, Greek, punctuation, indices, arrows, mathematics, geometry; 0 ends it. */
        private val RANGES =
            intArrayOf(0x20, 0xFF, 0x391, 0x3D5, 0x2013, 0x2032, 0x2070, 0x2097, 0x2190, 0x2193, 0x2211, 0x2265, 0x25B2, 0x26A0, 0)
    }
}
