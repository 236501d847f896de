package cga.framework

import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileSystemException

/** Why this failed, in the operating system's words where it gave any. */
public fun IOException.reason(): String =
    when (this) {
        is AccessDeniedException -> "permission denied"
        is FileSystemException -> reason ?: "no reason given"
        else -> message ?: "no reason given"
    }
