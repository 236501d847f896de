package cga.framework.context

import org.lwjgl.glfw.GLFW.*
import org.lwjgl.system.MemoryUtil.NULL

/** OSMesa through GLFW's null platform: typed calls, no display. */
internal class OsMesaContext : OffscreenContext {
    override val kind: ContextKind = ContextKind.OSMESA
    private val window: Long

    init {
        Glfw.start(GLFW_PLATFORM_NULL)?.let { throw ContextUnavailable("osmesa: GLFW's null platform did not start: $it.") }
        Glfw.hintCoreProfile()
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_OSMESA_CONTEXT_API)
        window =
            Glfw.openWindow(1, 1, "", NULL) { reason ->
                ContextUnavailable("osmesa: $reason. On Debian or Ubuntu: apt-get install libosmesa6 (Mesa before 25.1 has it).")
            }
    }

    override fun close(): Unit = Glfw.stop(window)
}
