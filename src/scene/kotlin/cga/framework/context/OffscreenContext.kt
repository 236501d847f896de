package cga.framework.context

import cga.framework.InputError
import kotlin.concurrent.thread

/** The three ways to an OpenGL 3.3 core context that shows nothing on a screen. */
public enum class ContextKind {
    /** Mesa's software renderer as a plain library: no display, no GPU. The goldens' renderer. */
    OSMESA,

    /** EGL without a window system: Mesa's software renderer where there is no GPU, a GPU without a display where there is one. */
    EGL,

    /** A hidden GLFW window: the way on Windows and macOS; on Linux it needs a display. */
    WINDOW,
}

/** A current OpenGL context of this thread, owned by whoever opened it; [close] ends it. At most one a process at a time. */
public interface OffscreenContext : AutoCloseable {
    public val kind: ContextKind

    public companion object {
        /** Opens a context of [kind], or the first that works when null. Throws [ContextUnavailable] with every reason. */
        public fun open(kind: ContextKind? = null): OffscreenContext {
            val candidates = if (kind != null) listOf(kind) else automaticOrder()
            val reasons = mutableListOf<ContextUnavailable>()
            for (candidate in candidates) {
                try {
                    return openExactly(candidate)
                } catch (e: ContextUnavailable) {
                    reasons += e
                }
            }
            throw reasons.singleOrNull() ?: ContextUnavailable(
                "no OpenGL 3.3 context can be made here:\n" + reasons.joinToString("\n") { "  ${it.message}" },
            )
        }

        /** Begins to load what [open] will need, on a thread of its own. Whatever is wrong with that, [open] says. */
        public fun prepare() {
            if (ContextKind.OSMESA in automaticOrder()) thread(isDaemon = true, name = "prepare") { OsMesaContext.library() }
        }

        private fun openExactly(kind: ContextKind): OffscreenContext =
            when (kind) {
                ContextKind.OSMESA -> OsMesaContext()
                ContextKind.EGL -> EglContext()
                ContextKind.WINDOW -> HiddenWindowContext()
            }

        // OSMesa and surfaceless EGL exist where Mesa does; elsewhere the window system's own driver is the only way.
        private fun automaticOrder(): List<ContextKind> =
            if (System.getProperty("os.name").startsWith("Linux")) ContextKind.entries else listOf(ContextKind.WINDOW)
    }
}

/** A way to a context that this machine does not offer; the message says why and what to install. */
public class ContextUnavailable(message: String) : InputError(message)
