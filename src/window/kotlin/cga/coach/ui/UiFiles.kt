package cga.coach.ui

/** The files that the panels are made of; they lie beside this class. */
internal object UiFiles {
    fun read(name: String): ByteArray {
        val file = UiFiles::class.java.getResourceAsStream(name) ?: error("the program lacks its file $name")
        return file.use { it.readAllBytes() }
    }
}
