package cga.testing

import java.lang.ProcessBuilder.Redirect.DISCARD
import java.util.concurrent.TimeUnit.SECONDS

/** A small window manager on [display]: windows have frames, can be minimised, and get the keyboard from it. */
class Openbox private constructor(private val display: Xvfb) : AutoCloseable {
    private val process =
        ProcessBuilder("openbox", "--sm-disable")
            .apply { environment() += display.variables }
            .redirectOutput(DISCARD)
            .redirectError(DISCARD)
            .start()

    init {
        // It answers for the desktop once it manages it.
        val deadline = System.nanoTime() + SECONDS.toNanos(LIMIT_SECONDS)
        while (display.xdotool("get_desktop").isEmpty()) {
            check(process.isAlive && System.nanoTime() < deadline) { "openbox does not start" }
            Thread.sleep(20)
        }
    }

    override fun close() {
        process.destroy()
        process.waitFor()
    }

    companion object {
        private const val LIMIT_SECONDS = 30L

        /** Starts it. Where it is missing the test is skipped, and in CI it fails. */
        fun startOrSkip(display: Xvfb): Openbox {
            if (!Xvfb.isInstalled("openbox")) Need.XVFB.skip("needs openbox: apt-get install openbox")
            return Openbox(display)
        }
    }
}
