package cga.framework.context

import org.lwjgl.egl.EGL
import org.lwjgl.egl.EGL15.*
import org.lwjgl.egl.EXTDeviceEnumeration.eglQueryDevicesEXT
import org.lwjgl.egl.EXTPlatformDevice.EGL_PLATFORM_DEVICE_EXT
import org.lwjgl.system.Configuration
import org.lwjgl.system.JNI
import org.lwjgl.system.MemoryStack
import org.lwjgl.system.MemoryUtil.NULL
import org.lwjgl.system.MemoryUtil.memAddress

/**
 * EGL without a window system.
 *
 * A display is looked for among the EGL devices (a GPU comes before Mesa's software device) and then on Mesa's surfaceless platform;
 * `LIBGL_ALWAYS_SOFTWARE=1` turns the order round, so that software rendering stays what was asked for.
 */
internal class EglContext : OffscreenContext {
    override val kind: ContextKind = ContextKind.EGL
    private val display: Long
    private val surface: Long
    private val context: Long

    init {
        loadLibrary()
        val (display, config) =
            displays().firstNotNullOfOrNull { display -> chooseConfig(display)?.let { display to it } }
                ?: unavailable("no EGL device or platform gives desktop OpenGL")
        this.display = display
        eglBindAPI(EGL_OPENGL_API)
        context = createContext(config)
        // One pixel, never drawn to: contexts without any surface are an extension, pbuffers are not.
        surface = MemoryStack.stackPush().use { eglCreatePbufferSurface(display, config, it.ints(EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE)) }
        if (surface == NULL || !eglMakeCurrent(display, surface, surface, context)) unavailable("eglMakeCurrent failed (${lastError()})")
        GlFunctions.load { name -> nameToAddress(memAddress(name)) }
    }

    override fun close() {
        GlFunctions.unload()
        JNI.callPPPPI(display, NULL, NULL, NULL, function("eglMakeCurrent"))
        eglDestroySurface(display, surface)
        eglDestroyContext(display, context)
        eglTerminate(display)
    }

    private fun loadLibrary() {
        if (libraryLoaded) return
        Configuration.EGL_EXPLICIT_INIT.set(true)
        try {
            EGL.create()
            libraryLoaded = true
        } catch (_: UnsatisfiedLinkError) {
            unavailable("libEGL was not found")
        }
    }

    /** Displays that initialise, best first. Lazy: a later one is not touched when an earlier one serves. */
    private fun displays(): Sequence<Long> {
        val surfaceless = sequenceOf(EGL_PLATFORM_SURFACELESS_MESA to NULL)
        val devices = sequence { yieldAll(devices().map { EGL_PLATFORM_DEVICE_EXT to it }) }
        val software = System.getenv("LIBGL_ALWAYS_SOFTWARE") in setOf("1", "true")
        return (if (software) surfaceless + devices else devices + surfaceless)
            .map { (platform, native) -> platformDisplay(platform, native) }
            .filter { it != NULL && initialise(it) }
    }

    private fun devices(): List<Long> {
        if (!EGL.getCapabilities().EGL_EXT_device_enumeration) return emptyList()
        return MemoryStack.stackPush().use { stack ->
            val devices = stack.mallocPointer(MAX_DEVICES)
            val count = stack.mallocInt(1)
            if (!eglQueryDevicesEXT(devices, count)) emptyList() else List(count[0]) { devices[it] }
        }
    }

    private fun initialise(display: Long): Boolean =
        MemoryStack.stackPush().use { stack ->
            val version = stack.mallocInt(2)
            val ok = eglInitialize(display, version, version.slice(1, 1))
            if (ok) EGL.createDisplayCapabilities(display, version[0], version[1])
            ok
        }

    private fun chooseConfig(display: Long): Long? =
        MemoryStack.stackPush().use { stack ->
            val wanted = stack.ints(EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE)
            val configs = stack.mallocPointer(1)
            val count = stack.mallocInt(1)
            if (eglChooseConfig(display, wanted, configs, count) && count[0] > 0) configs[0] else null
        }

    // The next two by address: their legal zero arguments are refused by LWJGL's typed forms.

    private fun platformDisplay(
        platform: Int,
        native: Long,
    ): Long {
        val address = function("eglGetPlatformDisplay").takeIf { it != NULL } ?: function("eglGetPlatformDisplayEXT")
        return if (address == NULL) NULL else JNI.callPPP(platform, native, NULL, address)
    }

    private fun createContext(config: Long): Long =
        MemoryStack.stackPush().use { stack ->
            val attributes =
                stack.ints(
                    EGL_CONTEXT_MAJOR_VERSION,
                    3,
                    EGL_CONTEXT_MINOR_VERSION,
                    3,
                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                    EGL_NONE,
                )
            val created = JNI.callPPPPP(display, config, NULL, memAddress(attributes), function("eglCreateContext"))
            if (created == NULL) unavailable("the driver gives no OpenGL 3.3 core context (${lastError()})")
            created
        }

    private fun nameToAddress(name: Long): Long = JNI.callPP(name, function("eglGetProcAddress"))

    private fun function(name: String): Long = EGL.getFunctionProvider().getFunctionAddress(name)

    private fun lastError(): String = "EGL error 0x%X".format(eglGetError())

    private fun unavailable(reason: String): Nothing =
        throw ContextUnavailable("egl: $reason. On Debian or Ubuntu: apt-get install libegl1 libgl1-mesa-dri.")

    private companion object {
        const val EGL_PLATFORM_SURFACELESS_MESA = 0x31DD
        const val MAX_DEVICES = 16

        // The library stays loaded for the process: drivers do not survive being unloaded.
        var libraryLoaded = false
    }
}
