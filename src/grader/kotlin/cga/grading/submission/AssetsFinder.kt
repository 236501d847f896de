package cga.grading.submission

import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name

/** Finds the folder that a submission expects to be started in: the one that holds `assets/`. */
internal object AssetsFinder {
    private val SHADERS = setOf("glsl", "vert", "frag", "vs", "fs", "vsh", "fsh")

    /** That folder, of several the one with shaders that lies nearest to [project]; null where there is no folder `assets`. */
    fun find(tree: FileTree, project: Path): Path? =
        tree.folders
            .filter { it.name == "assets" }
            .maxWithOrNull(
                compareBy(
                    { hasAny(tree, it, SHADERS) },
                    { hasAny(tree, it, setOf("obj")) },
                    { -distance(it.parent, project) },
                    { -it.nameCount },
                ),
            )?.parent

    private fun hasAny(tree: FileTree, folder: Path, extensions: Set<String>) =
        tree.files.any { it.startsWith(folder) && it.extension.lowercase() in extensions }

    /** Steps up and down from [a] to [b]. */
    private fun distance(a: Path, b: Path): Int = a.relativize(b).count { it.name.isNotEmpty() }
}
