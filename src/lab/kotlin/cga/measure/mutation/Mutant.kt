package cga.measure.mutation

import cga.exercise.game.Scene
import cga.framework.image.FloatImage
import cga.framework.image.ImageData

/** What of the render a [Mutant] spoils; headings of the table. */
public enum class Part(public val title: String) {
    LIGHTS("lights"),
    SHADING("shading"),
    GEOMETRY("geometry and camera"),
    TEXTURES("textures"),
    PICTURE("picture"),
}

/**
 * The render with one deliberate defect.
 *
 * @param name says what is wrong, in a few words; unique.
 * @param edits what is changed in files below `cga.home`; none where the defect is not in a file.
 * @param beforeRender changes the scene, or OpenGL's state; [afterRender] takes OpenGL's state back.
 * @param picture what happens to the finished picture, colours linear in 0..1.
 */
public class Mutant internal constructor(
    public val part: Part,
    public val name: String,
    internal val edits: List<Edit> = emptyList(),
    internal val beforeRender: (Scene) -> Unit = {},
    internal val afterRender: () -> Unit = {},
    internal val picture: ((FloatImage) -> FloatImage)? = null,
) {
    /** Whether the defect is in the shaders alone. */
    internal val isShader: Boolean get() = edits.isNotEmpty() && edits.all { it.file.startsWith("shaders/") }
}

/** One change of one file of the project, [file] relative to `cga.home`. */
internal sealed interface Edit {
    val file: String
}

/** Replaces [old], which must stand in the file exactly once, by [new]. */
internal class TextEdit(
    override val file: String,
    val old: String,
    val new: String,
) : Edit

/** Repaints a texture. */
internal class TextureEdit(
    override val file: String,
    val repaint: (ImageData) -> ImageData,
) : Edit
