package cga.measure.speed

import org.lwjgl.opengl.GL
import org.lwjgl.system.APIUtil.apiCreateLibrary
import org.lwjgl.system.FunctionProvider
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
        load { name -> if (isQuery(MemoryUtil.memASCII(name))) driver.getFunctionAddress(name) else nothing }
        try {
            return work()
        } finally {
            load(driver)
        }
    }

    // LWJGL itself asks for the version and for errors when it loads the functions.
    private fun isQuery(function: String) = function.startsWith("glGet")

    private fun load(driver: FunctionProvider) {
        GL.setCapabilities(null)
        GL.destroy()
        GL.create(driver)
        GL.createCapabilities(true)
    }
}
