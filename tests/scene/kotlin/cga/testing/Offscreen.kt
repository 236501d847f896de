package cga.testing

import cga.framework.context.ContextKind
import cga.framework.context.ContextUnavailable
import cga.framework.context.OffscreenContext
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
                needed(kind).skip(e.message.orEmpty())
            }

        /** What a context of [kind] is called among the needs of tests. */
        fun needed(kind: ContextKind?): Need = kind?.let { Need.valueOf(it.name) } ?: Need.OPENGL
    }
}
