package cga.measure.accuracy.choices

import cga.framework.ColorFormat
import cga.framework.SpecularModel

/** How llvmpipe filters textures. It reads that from its environment, once, so each filter has a process of its own. */
internal enum class TextureFilter(val environment: Map<String, String>) {
    EIGHT_BIT(emptyMap()),
    FLOAT(mapOf("GALLIVM_PERF" to "no_aos_sampling")),
}

/**
 * One way to draw the scene.
 *
 * @param samples of OpenGL a pixel; @param grid n draws n times as wide and high and takes the mean of n×n.
 */
internal data class Shot(
    val edits: List<ShaderEdit> = emptyList(),
    val format: ColorFormat = ColorFormat.RGBA8,
    val filter: TextureFilter = TextureFilter.EIGHT_BIT,
    val specular: SpecularModel = SpecularModel.BLINN_PHONG,
    val samples: Int = 0,
    val grid: Int = 1,
)

/**
 * A choice that a reader could make when drawing.
 *
 * @param timed what is timed: 8 bits a channel, as a window has, unless the choice says otherwise.
 * @param compared what is compared with [truth]. It differs where the picture as a whole would hide the error that the choice makes.
 */
internal class DrawingChoice(
    val group: DrawingGroup,
    val name: String,
    val timed: Shot,
    val compared: Shot,
    val truth: TruthKey = TruthKey(),
)

/**
 * Choices between which a reader chooses.
 *
 * @param isSmall whether the pictures have a quarter of the width and height, for a truth of 256 samples a pixel; then reading back and
 * averaging are part of the time, and every pixel is compared.
 */
internal enum class DrawingGroup(
    val title: String,
    val isSmall: Boolean = false,
) {
    LIGHTING("Lighting"),
    TARGET("Colour target"),
    FILTER("Texture filter of llvmpipe"),
    ANTIALIASING("Antialiasing", isSmall = true),
    EDGES("Antialiasing of edges alone", isSmall = true),
}

internal object DrawingChoices {
    val all: List<DrawingChoice> =
        lighting() + targets() + filters() + antialiasing(DrawingGroup.ANTIALIASING) + antialiasing(DrawingGroup.EDGES)

    private fun lighting(): List<DrawingChoice> {
        val wide = Cone(7.0, 24.0)
        val narrow = Cone(0.5, 1.0)
        return listOf(
            lighting("ours"),
            lighting("toLight per fragment", ShaderVariants.toLightPerFragment),
            lighting("light per vertex (Gouraud)", ShaderVariants.lightPerVertex()),
            lighting("Phong", specular = SpecularModel.PHONG),
            lighting("cosines, cone of 24°", ShaderVariants.cone(wide) + ShaderVariants.cosines, cone = wide),
            lighting("versines, cone of 1°", ShaderVariants.cone(narrow), cone = narrow),
            lighting("cosines, cone of 1°", ShaderVariants.cone(narrow) + ShaderVariants.cosines, cone = narrow),
        )
    }

    private fun lighting(
        name: String,
        edits: List<ShaderEdit> = emptyList(),
        specular: SpecularModel = SpecularModel.BLINN_PHONG,
        cone: Cone? = null,
    ) = DrawingChoice(
        DrawingGroup.LIGHTING,
        name,
        Shot(edits, specular = specular),
        Shot(edits + ShaderVariants.plain, ColorFormat.RGBA32F, specular = specular),
        TruthKey(specular, cone, Surface.PLAIN),
    )

    private fun targets() =
        listOf(ColorFormat.RGBA8, ColorFormat.RGBA16F, ColorFormat.RGBA32F).map { format ->
            val compared = Shot(ShaderVariants.firstLevel, format, TextureFilter.FLOAT)
            DrawingChoice(DrawingGroup.TARGET, format.name, Shot(format = format), compared, TruthKey(surface = Surface.FIRST_LEVEL))
        }

    private fun filters() =
        listOf(true, false).flatMap { firstLevel ->
            TextureFilter.entries.map { filter ->
                val shot = Shot(if (firstLevel) ShaderVariants.firstLevel else emptyList(), filter = filter)
                val name = (if (filter == TextureFilter.FLOAT) "float" else "8-bit") + if (firstLevel) ", largest level" else ", mip levels"
                DrawingChoice(
                    DrawingGroup.FILTER,
                    name,
                    shot,
                    shot.copy(format = ColorFormat.RGBA32F),
                    TruthKey(surface = if (firstLevel) Surface.FIRST_LEVEL else Surface.TEXTURED),
                )
            }
        }

    private fun antialiasing(group: DrawingGroup) =
        listOf(
            antialiasing(group, "none", Shot()),
            antialiasing(group, "4 samples of OpenGL", Shot(samples = 4)),
            antialiasing(group, "2×2 supersampling", Shot(grid = 2)),
            antialiasing(group, "4×4 supersampling", Shot(grid = 4)),
            antialiasing(group, "2×2 supersampling of 4 samples", Shot(samples = 4, grid = 2)),
        )

    private fun antialiasing(
        group: DrawingGroup,
        name: String,
        shot: Shot,
    ): DrawingChoice {
        val edits = if (group == DrawingGroup.EDGES) ShaderVariants.plain else emptyList()
        return DrawingChoice(group, name, shot, shot.copy(edits = edits, format = ColorFormat.RGBA32F), TruthKey.fine(group))
    }
}
