package cga.inspect.view

/** What a scene's programs were sent, and what they said of it. */
internal class Traffic {
    /** Sentences about uniforms that no shader declares; each is said once until the shaders are loaded anew. */
    val warnings: MutableSet<String> = LinkedHashSet()

    /** Names of the uniforms that were set while [isRecorded]. */
    val sent: MutableSet<String> = LinkedHashSet()
    var isRecorded: Boolean = false

    fun sent(name: String) {
        if (isRecorded) sent += name
    }
}
