package cga.testing

import java.nio.file.Path
import kotlin.io.path.createFile

/**
 * The environment of a process that finds neither OSMesa nor EGL nor a display.
 *
 * Empty files in [folder] hide the libraries: the loader finds them first and cannot use them.
 */
fun withoutOpenGL(folder: Path): Map<String, String?> {
    for (library in listOf("libOSMesa.so", "libOSMesa.so.6", "libOSMesa.so.8", "libEGL.so", "libEGL.so.1")) {
        folder.resolve(library).createFile()
    }
    return NO_DISPLAY + ("LD_LIBRARY_PATH" to "$folder")
}

/** The variables that name a display, removed. */
val NO_DISPLAY: Map<String, String?> = mapOf("DISPLAY" to null, "WAYLAND_DISPLAY" to null)
