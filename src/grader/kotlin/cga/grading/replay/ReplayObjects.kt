package cga.grading.replay

import cga.framework.image.ImageData
import cga.grading.capture.Capture
import cga.grading.capture.CapturedProgram
import cga.grading.capture.CapturedTexture
import cga.grading.capture.GlNumbers
import org.lwjgl.opengl.EXTTextureFilterAnisotropic.GL_TEXTURE_MAX_ANISOTROPY_EXT
import org.lwjgl.opengl.GL
import org.lwjgl.opengl.GL33C.*
import org.lwjgl.system.MemoryUtil
import java.util.IdentityHashMap

/** The programs, buffers and textures of a capture on the GPU, each made when it is first needed. */
internal class ReplayObjects(private val capture: Capture) : AutoCloseable {
    private val programs = IdentityHashMap<CapturedProgram, ReplayProgram>()
    private val buffers = HashMap<Int, Int>()
    private val textures = HashMap<Int, Int>()
    private val pictures = IdentityHashMap<ImageData, Int>()

    fun program(captured: CapturedProgram): ReplayProgram = programs.getOrPut(captured) { ReplayProgram(captured) }

    /** OpenGL's name of buffer [number]. */
    fun buffer(number: Int): Int =
        buffers.getOrPut(number) {
            val name = glGenBuffers()
            // A target that changes nothing else.
            glBindBuffer(GL_COPY_WRITE_BUFFER, name)
            withBytes(capture.buffers[number]) { glBufferData(GL_COPY_WRITE_BUFFER, it, GL_STATIC_DRAW) }
            name
        }

    /** Binds texture [number] to the active unit. */
    fun bindTexture(number: Int) {
        val name = textures[number]
        val texture = capture.textures[number]
        if (name != null) glBindTexture(texture.target, name) else textures[number] = upload(texture)
    }

    /** Binds [picture] to the active unit; its top row is the texture's last. */
    fun bindPicture(picture: ImageData) {
        val name = pictures[picture]
        if (name != null) return glBindTexture(GL_TEXTURE_2D, name)
        pictures[picture] =
            upload(
                CapturedTexture(
                    picture.width, picture.height, listOf(picture.rgba), GL_REPEAT, GL_REPEAT, GL_LINEAR, GL_LINEAR,
                ),
            )
    }

    private fun upload(texture: CapturedTexture): Int {
        val name = glGenTextures()
        val target = texture.target
        glBindTexture(target, name)
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4)
        texture.levels.forEachIndexed { level, texels -> upload(texture, level, texels) }
        glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, texture.levels.lastIndex)
        glTexParameteri(target, GL_TEXTURE_WRAP_S, texture.wrapS)
        glTexParameteri(target, GL_TEXTURE_WRAP_T, texture.wrapT)
        glTexParameteri(target, GL_TEXTURE_WRAP_R, texture.wrapR)
        texture.border?.let { glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, it.toFloatArray()) }
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, texture.minFilter)
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, texture.magFilter)
        // Without mipmaps software rendering can hang on it, and the worker turned it off as well.
        if (texture.maxAnisotropy > 1f && texture.minFilter in GlNumbers.mipmapFilters &&
            GL.getCapabilities().GL_EXT_texture_filter_anisotropic
        ) {
            glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, texture.maxAnisotropy)
        }
        return name
    }

    private fun upload(
        texture: CapturedTexture,
        level: Int,
        texels: ByteArray,
    ) {
        if (texture.depth != 0) return uploadDepth(texture, level, texels)
        val face = texels.size / texture.faces
        val width = maxOf(1, texture.width shr level)
        val height = maxOf(1, texture.height shr level)
        withBytes(texels) { bytes ->
            for (number in 0 until texture.faces) {
                glTexImage2D(
                    if (texture.isCube) GL_TEXTURE_CUBE_MAP_POSITIVE_X + number else GL_TEXTURE_2D, level,
                    if (texture.srgb) GL_SRGB8_ALPHA8 else GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    bytes.position(number * face),
                )
            }
        }
    }

    private fun uploadDepth(
        texture: CapturedTexture,
        level: Int,
        texels: ByteArray,
    ): Unit = withBytes(texels) {
        val width = maxOf(1, texture.width shr level)
        val height = maxOf(1, texture.height shr level)
        glTexImage2D(GL_TEXTURE_2D, level, texture.depth, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, it)
    }

    private val CapturedTexture.target: Int get() = if (isCube) GL_TEXTURE_CUBE_MAP else GL_TEXTURE_2D

    override fun close() {
        programs.values.forEach { glDeleteProgram(it.name) }
        buffers.values.forEach { glDeleteBuffers(it) }
        (textures.values + pictures.values).forEach { glDeleteTextures(it) }
    }

    private fun withBytes(
        bytes: ByteArray,
        use: (java.nio.ByteBuffer) -> Unit,
    ) {
        val native = MemoryUtil.memAlloc(maxOf(bytes.size, 1)).limit(bytes.size)
        try {
            use(native.put(bytes).flip())
        } finally {
            MemoryUtil.memFree(native)
        }
    }
}
