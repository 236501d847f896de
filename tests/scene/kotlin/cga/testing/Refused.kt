package cga.testing

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.assertThrows

/** Asserts that [action] is an [IllegalArgumentException] whose message holds each of [values], as text. */
fun assertRefused(vararg values: Any, action: () -> Unit) {
    val message = assertThrows<IllegalArgumentException> { action() }.message.orEmpty()
    for (value in values) assertTrue("$value" in message) { "the message does not say $value: $message" }
}
