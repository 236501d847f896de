package cga.framework

import org.lwjgl.Version
import org.lwjgl.system.Configuration
import org.lwjgl.system.Platform
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.function.Function

/**
 * Where LWJGL's libraries for this platform lie unpacked.
 *
 * Without it LWJGL looks for them on the whole class path at each start, compares each with the copy in the folder for temporary files,
 * and loads that.
 */
public object Natives {
    /** Has LWJGL load its libraries from [folder], where each is unpacked when it is first needed. Call it before anything of LWJGL's. */
    public fun keepIn(folder: Path) {
        Configuration.BUNDLED_LIBRARY_NAME_MAPPER.set(Function<String, String> { name -> unpacked(name, folder)?.toString() ?: name })
    }

    /** Null where it cannot be unpacked: LWJGL then has ways and messages of its own. */
    private fun unpacked(
        name: String,
        folder: Path,
    ): Path? {
        val platform = "${Platform.get().getName()}/${Platform.getArchitecture()}".lowercase()
        val library = System.mapLibraryName(name)
        val file = folder.resolve("$VERSION/$platform/$library").toAbsolutePath()
        if (Files.exists(file)) return file
        // Those of LWJGL's own are named after the module, as in lwjgl_opengl; the first after LWJGL alone.
        val module = if (name == "lwjgl") "" else name.removePrefix("lwjgl_") + "/"
        val packed = Platform::class.java.getResource("/$platform/org/lwjgl/$module$library") ?: return null
        return try {
            Files.createDirectories(file.parent)
            AtomicFile.write(file) { temporary -> packed.openStream().use { Files.copy(it, temporary) } }
            file
        } catch (_: IOException) {
            null
        } catch (_: InputError) {
            null
        }
    }

    private const val VERSION = "${Version.VERSION_MAJOR}.${Version.VERSION_MINOR}.${Version.VERSION_REVISION}"
}
