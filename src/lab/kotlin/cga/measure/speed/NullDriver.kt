package cga.measure.speed

import cga.framework.context.GlFunctions
import org.lwjgl.opengl.GL
import org.lwjgl.system.APIUtil.apiCreateLibrary
import org.lwjgl.system.MemoryUtil

/**
 * A driver that does nothing: what then is left of a frame is our own code and the step from Java to C.
 *
 * Every OpenGL function but the queries becomes libc's `abs`, which ignores whatever else it is handed. So nothing can be made or read
 * meanwhile, only drawn with what is there. Linux only.
 */
internal object NullDriver {
    private val nothing = apiCreateLibrary("libc.so.6").getFunctionAddress("abs")

    /** Runs [work] without a driver, in a context that is current; afterwards the driver is back. */
    fun <T> use(work: () -> T): T {
        val driver = checkNotNull(GL.getFunctionProvider()) { "no context is current" }
        GlFunctions.load { name -> if (isQuery(MemoryUtil.memASCII(name))) driver.getFunctionAddress(name) else nothing }
        try {
            return work()
        } finally {
            GlFunctions.load(driver::getFunctionAddress)
        }
    }

    // LWJGL itself asks for the version and for errors when it loads the functions.
    private fun isQuery(function: String) = function.startsWith("glGet")
}
