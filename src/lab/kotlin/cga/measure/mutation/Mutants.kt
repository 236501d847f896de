package cga.measure.mutation

/** Every mutant, in the order of the table. */
public object Mutants {
    public val ALL: List<Mutant> = LIGHT_MUTANTS + SHADING_MUTANTS + GEOMETRY_MUTANTS + TEXTURE_MUTANTS + PICTURE_MUTANTS

    /** The mutant called [name]. */
    public fun of(name: String): Mutant = ALL.single { it.name == name }
}

/** A mutant of the fragment shader: [old], which stands there once, becomes [new]. */
internal fun Part.fragment(
    name: String,
    old: String,
    new: String,
): Mutant = Mutant(this, name, listOf(TextEdit("shaders/scene.frag", old, new)))

/** The same of the functions that the fragment shader includes. */
internal fun Part.lighting(
    name: String,
    old: String,
    new: String,
): Mutant = Mutant(this, name, listOf(TextEdit("shaders/lighting.glsl", old, new)))

/** The same of the vertex shader. */
internal fun Part.vertex(
    name: String,
    old: String,
    new: String,
): Mutant = Mutant(this, name, listOf(TextEdit("shaders/scene.vert", old, new)))
