package cga.testing

import cga.framework.context.ContextKind
import cga.framework.context.ContextUnavailable
import cga.framework.context.OffscreenContext
import org.junit.jupiter.api.Assertions.fail
import org.junit.jupiter.api.Assumptions.abort
import org.junit.jupiter.api.extension.AfterAllCallback
import org.junit.jupiter.api.extension.BeforeAllCallback
import org.junit.jupiter.api.extension.ExtensionContext

/** An OpenGL context for a test class, from before its first test to after its last: `@ExtendWith(Offscreen::class)`. */
class Offscreen :
    BeforeAllCallback,
    AfterAllCallback {
    private var context: OffscreenContext? = null

    override fun beforeAll(test: ExtensionContext) {
        context = openOrSkip()
    }

    override fun afterAll(test: ExtensionContext) {
        context?.close()
    }

    companion object {
        /** A context of [kind], or of the first kind that works. Where there is none the test is skipped, and in CI it fails. */
        fun openOrSkip(kind: ContextKind? = null): OffscreenContext =
            try {
                OffscreenContext.open(kind)
            } catch (e: ContextUnavailable) {
                skip(e.message.orEmpty())
            }

        /** Ends the test as skipped for want of something that this machine lacks; in CI, which shall lack nothing, as failed. */
        fun skip(reason: String): Nothing = if (System.getenv("CI") == null) abort(reason) else fail(reason)
    }
}
