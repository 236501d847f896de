package cga.grading.course

import java.security.MessageDigest

/** SHA-256 of [text] in hexadecimal. */
internal fun sha256(text: String): String = hex(MessageDigest.getInstance("SHA-256").digest(text.toByteArray()))

internal fun hex(bytes: ByteArray): String = bytes.joinToString("") { "%02x".format(it) }
