package cga.grading.compile

import cga.grading.prepared.PreparedTree

/** A library by its Maven coordinates. @param classifier of a file beside the library itself, such as `natives-linux`. */
public data class Artifact(
    public val group: String,
    public val name: String,
    public val version: String,
    public val classifier: String? = null,
) {
    init {
        // They become paths and addresses, and the version comes from a student's build file.
        require(listOfNotNull(group, name, version, classifier).all(PreparedTree::isCoordinate)) {
            "not the coordinates of a library: $group:$name:$version"
        }
    }

    /** The folder of all versions in a repository. */
    internal val folder: String get() = "${group.replace('.', '/')}/$name"

    /** The path of its file of type [extension] in a repository. */
    internal fun path(extension: String): String = "$folder/$version/${fileName(extension)}"

    internal fun fileName(extension: String): String = "$name-$version${classifier?.let { "-$it" }.orEmpty()}.$extension"

    override fun toString(): String = "$group:$name:$version"
}
