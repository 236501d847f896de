package cga.coach

import java.net.URL
import java.net.URLClassLoader
import java.nio.file.Files
import java.nio.file.Path

/**
 * Finds the tools, which lie in a jar beside that of this class. Theirs is a class loader of its own: a student's program may have classes of
 * the same names, and meets none of them.
 */
internal object Tools {
    private const val JAR = "cga-coach-tools.jar"
    private const val HOST = "cga.coach.host.CoachHost"

    val host: Host by lazy {
        val here = Tools::class.java
        val jar = here.protectionDomain.codeSource?.location?.let { Path.of(it.toURI()).resolveSibling(JAR) }
        val loader = if (jar != null && Files.exists(jar)) Loader(jar.toUri().toURL(), here.classLoader) else here.classLoader
        loader.loadClass(HOST).getConstructor().newInstance() as Host
    }

    /** Our classes from [jar], all others from [parent], and of ours those few that both sides know. */
    private class Loader(
        jar: URL,
        parent: ClassLoader,
    ) : URLClassLoader(arrayOf(jar), parent) {
        override fun loadClass(
            name: String,
            resolve: Boolean,
        ): Class<*> {
            if (!name.startsWith("cga.")) return super.loadClass(name, resolve)
            synchronized(getClassLoadingLock(name)) {
                findLoadedClass(name)?.let { return it }
                val isTool = findResource(name.replace('.', '/') + ".class") != null
                return if (isTool) findClass(name) else super.loadClass(name, resolve)
            }
        }
    }
}
