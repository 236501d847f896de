package cga.testing

import org.junit.jupiter.api.extension.AfterAllCallback
import org.junit.jupiter.api.extension.BeforeAllCallback
import org.junit.jupiter.api.extension.ExtensionContext
import org.junit.jupiter.api.extension.ParameterContext
import org.junit.jupiter.api.extension.ParameterResolver

/**
 * A display for a test class, from before its first test to after its last: `@ExtendWith(OnXvfb::class)`. Its constructor, or a test,
 * takes it as a parameter.
 */
class OnXvfb :
    BeforeAllCallback,
    AfterAllCallback,
    ParameterResolver {
    private var display: Xvfb? = null

    override fun beforeAll(test: ExtensionContext) {
        display = Xvfb.openOrSkip()
    }

    override fun afterAll(test: ExtensionContext) {
        display?.close()
    }

    override fun supportsParameter(
        parameter: ParameterContext,
        test: ExtensionContext,
    ): Boolean = parameter.parameter.type == Xvfb::class.java

    override fun resolveParameter(
        parameter: ParameterContext,
        test: ExtensionContext,
    ): Any? = display
}
