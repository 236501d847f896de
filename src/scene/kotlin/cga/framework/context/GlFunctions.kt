package cga.framework.context

import org.lwjgl.opengl.GL
import org.lwjgl.system.Configuration
import org.lwjgl.system.FunctionProvider
import java.nio.ByteBuffer

/**
 * Tells LWJGL where the OpenGL functions of the current context come from.
 *
 * LWJGL would load the system's libGL by itself on first use; that library need not exist (OSMesa) or be the right one (EGL),
 * so loading is explicit and every context brings its own look-up.
 */
public object GlFunctions {
    init {
        Configuration.OPENGL_EXPLICIT_INIT.set(true)
    }

    /** Makes [address] (name → function address or 0) the source of OpenGL's functions, and reads what the context can do. */
    public fun load(address: (ByteBuffer) -> Long) {
        unload()
        GL.create(FunctionProvider { name -> address(name) })
        GL.createCapabilities(true)
    }

    /** Forgets the functions; safe to call when none are loaded. */
    public fun unload() {
        if (GL.getFunctionProvider() == null) return
        GL.setCapabilities(null)
        GL.destroy()
    }
}
