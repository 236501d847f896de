package cga.framework.context

import cga.framework.Phases
import org.lwjgl.opengl.GL33C.GL_FALSE
import org.lwjgl.opengl.GL33C.GL_RGBA
import org.lwjgl.opengl.GL33C.GL_UNSIGNED_BYTE
import org.lwjgl.system.APIUtil.apiCreateLibrary
import org.lwjgl.system.JNI
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil
import org.lwjgl.system.MemoryUtil.NULL
import org.lwjgl.system.MemoryUtil.memAddress
import org.lwjgl.system.Platform
import org.lwjgl.system.SharedLibrary

/**
 * OSMesa: a library of Mesa's that needs no display and no window, and draws to memory.
 *
 * Its few functions are called by address, for LWJGL has no typed forms of them. GLFW has (on its null platform), but loading and starting
 * it would take longer than all of this.
 */
internal class OsMesaContext : OffscreenContext {
    override val kind: ContextKind = ContextKind.OSMESA
    private val library = library() ?: unavailable("libOSMesa was not found")
    private val context = Phases.span("osmesa-context") { create() }

    // One pixel, never drawn to: a context is current only with a buffer.
    private val pixel = MemoryUtil.memAlloc(PIXEL_BYTES)

    init {
        // A GLboolean is a byte; what lies above it in the register is nothing.
        val current = JNI.callPPI(context, memAddress(pixel), GL_UNSIGNED_BYTE, 1, 1, function("OSMesaMakeCurrent")) and 0xFF
        if (current == GL_FALSE) {
            release()
            unavailable("OSMesaMakeCurrent failed")
        }
        val lookup = function("OSMesaGetProcAddress")
        Phases.span("gl-functions") { GlFunctions.load { name -> JNI.callPP(memAddress(name), lookup) } }
    }

    override fun close() {
        GlFunctions.unload()
        JNI.callPPI(NULL, NULL, 0, 0, 0, function("OSMesaMakeCurrent"))
        release()
    }

    private fun release() {
        JNI.callPV(context, function("OSMesaDestroyContext"))
        MemoryUtil.memFree(pixel)
    }

    private fun create(): Long {
        // Mesa before 12 has no such function, and no OpenGL 3.3 either.
        val create = function("OSMesaCreateContextAttribs")
        val created =
            if (create == NULL) NULL else MemoryStack.stackPush().use { JNI.callPPP(memAddress(it.ints(*ATTRIBUTES)), NULL, create) }
        if (created == NULL) unavailable("it gives no OpenGL 3.3 core context")
        return created
    }

    private fun function(name: String): Long = library.getFunctionAddress(name)

    private fun unavailable(reason: String): Nothing =
        throw ContextUnavailable("osmesa: $reason. On Debian or Ubuntu: apt-get install libosmesa6 (Mesa before 25.1 has it).")

    companion object {
        private const val PIXEL_BYTES = 4

        // Pairs, by the names of GL/osmesa.h: OSMESA_FORMAT GL_RGBA, OSMESA_DEPTH_BITS 24, OSMESA_STENCIL_BITS 8, OSMESA_ACCUM_BITS 0,
        // OSMESA_PROFILE OSMESA_CORE_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION 3, OSMESA_CONTEXT_MINOR_VERSION 3.
        private val ATTRIBUTES = intArrayOf(0x22, GL_RGBA, 0x30, 24, 0x31, 8, 0x32, 0, 0x33, 0x34, 0x36, 3, 0x37, 3, 0)

        // It stays loaded for the process: drivers do not survive being unloaded.
        private var loaded: SharedLibrary? = null

        /** The library, loaded when first asked for; null where there is none. */
        @Synchronized
        fun library(): SharedLibrary? =
            loaded ?: Phases.span("osmesa") { names().firstNotNullOfOrNull(::loadedOrNull) }.also { loaded = it }

        private fun loadedOrNull(name: String): SharedLibrary? =
            try {
                apiCreateLibrary(name)
            } catch (_: UnsatisfiedLinkError) {
                null
            }

        private fun names() =
            when (Platform.get()) {
                Platform.WINDOWS -> listOf("libOSMesa.dll", "OSMesa.dll")
                Platform.MACOSX -> listOf("libOSMesa.8.dylib", "libOSMesa.dylib")
                else -> listOf("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so")
            }
    }
}
