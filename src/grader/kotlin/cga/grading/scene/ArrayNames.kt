package cga.grading.scene

/** Names of uniforms that are elements of an array, as OpenGL spells them: `lights[3].color`. */
internal object ArrayNames {
    /** The first number of an element, with its brackets; a program may well ask for −1. */
    val ELEMENT: Regex = Regex("""\[-?\d+]""")

    /** What all elements of an array have in common: [name] without the number; null where it is no element. */
    fun arrayOf(name: String): String? = if (ELEMENT in name) name.replaceFirst(ELEMENT, "[]") else null
}
