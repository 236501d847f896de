package cga.testing

import org.junit.jupiter.api.Assertions.fail
import org.junit.jupiter.api.Assumptions.abort

/**
 * What a test can need that a machine may lack. Every test that is skipped for want of something ends by [skip]; only what an operating
 * system cannot have at all is a plain assumption.
 *
 * In CI, where the variable `CI` is set, nothing shall be lacking: there such a test fails, unless the variable `CGA_SKIPS` announces the
 * lack. It holds the names of these constants in lower case, separated by blanks, as in `CGA_SKIPS="sandbox root"`.
 */
enum class Need {
    /** A context that draws, of any kind. */
    OPENGL,

    /** A context of OSMesa. */
    OSMESA,

    /** A context of EGL. */
    EGL,

    /** A context of a window that is not shown. */
    WINDOW,

    /** Mesa's software renderer, whose bytes are known. */
    LLVMPIPE,

    /** bubblewrap, and the kernel's leave to use it. */
    SANDBOX,

    /** A user other than root, whom permissions hold back. */
    ROOT,

    /** Xvfb, xdotool and Openbox. */
    XVFB,

    /** Chromium or Chrome. */
    BROWSER,

    /** A C++ compiler and GLM. */
    GLM,

    SHELLCHECK,

    MAVEN,
    ;

    private val key = name.lowercase()

    /**
     * Ends the test as skipped because of [why], which says what is lacking and where possible how to get it.
     *
     * @throws org.opentest4j.TestAbortedException where a lack may be.
     * @throws org.opentest4j.AssertionFailedError in CI, where nobody announced it.
     */
    fun skip(why: String, environment: Map<String, String> = System.getenv()): Nothing {
        val isAnnounced = key in environment["CGA_SKIPS"].orEmpty().split(' ')
        if (environment["CI"].isNullOrEmpty() || isAnnounced) abort<Nothing>("$key: $why")
        fail<Nothing>("$why. In CI this is skipped only where CGA_SKIPS names it: CGA_SKIPS=\"$key\"")
    }
}
