package cga.testing

import org.junit.jupiter.api.Tag

/**
 * A test class that takes seconds. `./cga test --fast`, which is what one runs before a commit, leaves it out; so do Maven and Gradle with
 * `-Dcga.tests=fast`.
 */
@Target(AnnotationTarget.CLASS)
@Tag("slow")
annotation class Slow
