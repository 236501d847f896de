package cga.grading.worker

import java.net.URL
import java.net.URLClassLoader

/** Loads the submission's own classes from [places], with their questions for time and keys rerouted; all others are the worker's. */
internal class SubmissionLoader(places: List<URL>) : URLClassLoader(places.toTypedArray(), SubmissionLoader::class.java.classLoader) {
    override fun findClass(name: String): Class<*> {
        val file = findResource(name.replace('.', '/') + ".class") ?: throw ClassNotFoundException(name)
        val bytes = Rerouting.of(file.openStream().use { it.readBytes() })
        return defineClass(name, bytes, 0, bytes.size)
    }
}
