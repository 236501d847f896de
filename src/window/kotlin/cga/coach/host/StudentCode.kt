package cga.coach.host

import cga.coach.Host
import java.lang.reflect.InvocationTargetException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.readBytes
import kotlin.io.path.relativeTo

/**
 * The student's classes as they lie in [folder] at one moment. They are read at once: a compiler may replace them while the program runs.
 */
internal class StudentCode(folder: Path) {
    private val classes: Map<String, ByteArray> =
        if (!folder.exists()) {
            emptyMap()
        } else {
            Files.walk(folder).use { paths -> paths.filter { it.extension == "class" }.toList() }.associate { file ->
                file.relativeTo(folder).invariantSeparatorsPathString.removeSuffix(".class").replace('/', '.') to file.readBytes()
            }
        }

    /** Whether the class called [name] is one of theirs. */
    fun has(name: String): Boolean = name in classes

    /** Calls `main` of [mainClass] in a class loader of its own. */
    fun start(mainClass: String) {
        val loader = Loader()
        val thread = Thread.currentThread()
        val before = thread.contextClassLoader
        thread.contextClassLoader = loader
        try {
            val main = loader.loadClass(mainClass)
            val withArguments = main.methods.firstOrNull { it.name == "main" && it.parameterCount == 1 }
            if (withArguments != null) withArguments.invoke(null, emptyArray<String>()) else main.getMethod("main").invoke(null)
        } catch (e: InvocationTargetException) {
            throw e.cause ?: e
        } finally {
            thread.contextClassLoader = before
        }
    }

    /** Theirs before all others of the same name, which the program was started with. */
    private inner class Loader : ClassLoader(Host::class.java.classLoader) {
        override fun loadClass(
            name: String,
            resolve: Boolean,
        ): Class<*> {
            val bytes = classes[name] ?: return super.loadClass(name, resolve)
            synchronized(getClassLoadingLock(name)) { return findLoadedClass(name) ?: defineClass(name, bytes, 0, bytes.size) }
        }
    }
}
