package cga.inspect.soak

import org.lwjgl.opengl.GL33C.*

/** How many objects the current OpenGL context holds. OpenGL does not tell: drivers hand out small names, which are asked for one by one. */
internal object GlObjects {
    private const val NAMES = 4096

    /** Textures, buffers, vertex arrays, framebuffers, renderbuffers, programs and shaders together. */
    fun count(): Int =
        (1..NAMES).sumOf { name ->
            KINDS.count { it(name) }
        }

    private val KINDS: List<(Int) -> Boolean> =
        listOf(
            { glIsTexture(it) },
            { glIsBuffer(it) },
            { glIsVertexArray(it) },
            { glIsFramebuffer(it) },
            { glIsRenderbuffer(it) },
            { glIsProgram(it) },
            { glIsShader(it) },
        )
}
