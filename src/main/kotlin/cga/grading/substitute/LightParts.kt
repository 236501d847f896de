package cga.grading.substitute

import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC2
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC4

/**
 * The uniforms of one light.
 *
 * @param attenuation GLSL for (K_c, K_l, K_q); null where they are not sent.
 * @param direction null for a point light, likewise [inner] and [outer], GLSL for the cone's two numbers, where they were found.
 */
internal class LightParts(
    val position: String,
    val color: String,
    val attenuation: String?,
    val direction: String?,
    val inner: String?,
    val outer: String?,
)

/**
 * Which uniforms belong together, told by what is left of their names without the words for the part.
 *
 * @property lights in the order of their places' uniforms.
 * @property tint name of the emission's factor: a colour that differs between the draws of a picture, or is called so.
 * @property rest vectors that nothing is known of.
 */
internal class LightGroups(
    private val sent: Sent,
) {
    private val vectors = (sent.names(GL_FLOAT_VEC3) + sent.names(GL_FLOAT_VEC4)).map(::UniformName)
    private val numbers = (sent.names(GL_FLOAT) + sent.names(GL_FLOAT_VEC2)).map(::UniformName)
    private val eye = vectors.filter { it.says("cam", "eye", "auge", "viewpos", "kamera") || (it.says("view") && part(it) == Part.POSITION && it.owner == "view") }
    private val ambient = vectors.filter { it.says("amb") }
    val tint: String? = (vectors.find { isPaint(it) && differs(it.name) } ?: vectors.find { isPaint(it) && it.says(*TINT) })?.name
    private val known = vectors.filter { it !in eye && it !in ambient && it.name != tint }
    private val places = known.filter { part(it) == Part.POSITION }
    private val colors = known.filter { part(it) == Part.COLOR }
    private val directions = known.filter { part(it) == Part.DIRECTION && isEver(it.name) }
    private val fades = known.filter { part(it) == Part.ATTENUATION }
    private val pairs = pairs()
    private val spots: Set<String> = pairs.keys.filter { owner -> directions.any { it.owner == owner } || numbers.any { it.owner == owner && isCone(it) } }.toSet()
    val lights: List<LightParts> = pairs.filterValues(::isSent).map { (owner, pair) -> light(owner, pair.first.name, pair.second.name) }
    val rest: List<String> = (known - (pairs.values.flatMap { it.toList() } + fades).toSet()).filter { part(it) != Part.DIRECTION }.map { it.name }

    /** Place and colour of each light, by its words. Where one of each is left over with different words, they are one light's. */
    private fun pairs(): Map<String, Pair<UniformName, UniformName>> {
        val named = places.mapNotNull { place -> colors.find { it.owner == place.owner }?.let { place.owner to (place to it) } }.toMap()
        val lonely = places.filter { it.owner !in named }
        val spare = colors.filter { it.owner !in named }
        return if (lonely.size != spare.size) named else named + lonely.zip(spare).associate { (place, color) -> place.owner to (place to color) }
    }

    /** Whether one of [pair] is ever anything: arrays may be longer than there are lights. */
    private fun isSent(pair: Pair<UniformName, UniformName>) = pair.toList().any { isEver(it.name) }

    private fun isEver(name: String) = sent.vectors(name).any { it.lengthSquared() > 0 }

    private fun light(
        owner: String,
        place: String,
        color: String,
    ): LightParts {
        val aimed = directions.find { it.owner == owner } ?: directions.singleOrNull()?.takeIf { isHeadlight(owner) }
        val direction = aimed?.takeUnless { isEverywhere(owner) }
        val (inner, outer) = if (direction == null) null to null else cone(owner)
        return LightParts(place, color, fade(owner), direction?.name, inner, outer)
    }

    /** Whether what has lost its owner belongs to this one: the only spotlight, or what is called one. */
    private fun isHeadlight(owner: String): Boolean =
        (spots.singleOrNull() ?: pairs.keys.singleOrNull { UniformName(it).says("spot", "head", "scheinw", "strahler", "front", "beam") }) == owner

    private fun cone(owner: String): Pair<String?, String?> {
        val all = numbers.filter { isCone(it) && (it.owner == owner || (pairs.keys.none { other -> it.owner == other } && isHeadlight(owner))) }
        all.find { sent.types[it.name] == GL_FLOAT_VEC2 }?.let { return cosines("${it.name}.x", "${it.name}.y", sent.frames.last().last().numbers(it.name)) }
        val outer = all.find { Part.OUTER in it.parts } ?: return null to all.firstOrNull()?.let { cosine(it.name, number(it.name)) }
        val inner = all.find { Part.INNER in it.parts } ?: all.find { it != outer } ?: return null to cosine(outer.name, number(outer.name))
        return cosines(inner.name, outer.name, floatArrayOf(number(inner.name), number(outer.name)))
    }

    /** Whether the cone of [owner] is one of all directions: half a circle or more to each side, or a cosine that none is below. */
    private fun isEverywhere(owner: String): Boolean {
        val values = numbers.filter { it.owner == owner && isCone(it) }.flatMap { sent.frames.last().last().numbers(it.name).toList() }
        return values.any { it <= -1f || (it > NEARLY_PI && it < 2 * NEARLY_PI) || it >= HALF_CIRCLE }
    }

    /** GLSL for the cosines of two angles, that of the narrower first: whichever way round is sent, the shader would have to tell. */
    private fun cosines(
        inner: String,
        outer: String,
        values: FloatArray,
    ): Pair<String, String> {
        // Angles, unless the first is larger: so are cosines of a narrow one.
        val isCosine = values.all { it in 0f..1f } && values[0] > values[1]
        val both = listOf(inner, outer).zip(values.toList()).sortedBy { if (isCosine) -it.second else it.second }.map { it.first }
        return if (isCosine) both[0] to both[1] else cosine(both[0], values.max()) to cosine(both[1], values.max())
    }

    private fun cosine(
        name: String,
        largest: Float,
    ) = if (largest > Math.PI / 2) "cos(radians($name))" else "cos($name)"

    private fun number(name: String) = sent.frames.last().last().numbers(name)[0]

    private fun fade(owner: String): String? {
        fades.find { it.owner == owner }?.let { return "${it.name}.xyz" }
        val factors = listOf(Part.CONSTANT, Part.LINEAR, Part.QUADRATIC).map { part -> numbers.find { it.owner == owner && part in it.parts }?.name }
        if (factors.any { it != null }) return "vec3(${factors.joinToString { it ?: "0.0" }})"
        val spare = fades.filter { fade -> pairs.keys.none { it == fade.owner } }
        return spare.singleOrNull()?.let { "${it.name}.xyz" }
    }

    private fun isCone(name: UniformName) = name.parts.any { it == Part.INNER || it == Part.OUTER || it == Part.CONE }

    private fun isPaint(name: UniformName) = part(name).let { it == Part.COLOR || it == null } && sent.types[name.name] == GL_FLOAT_VEC3 && !name.says("amb")

    private fun differs(name: String) = sent.frames.any { frame -> frame.any { it.vector(name) != frame[0].vector(name) } }

    private fun part(name: UniformName): Part? = name.parts.firstOrNull { it in OF_VECTORS } ?: Part.ATTENUATION.takeIf { isTable1(name.name) }

    private fun isTable1(name: String) = sent.frames.last().last().vector(name).let { value -> TABLE_1.any { it.distance(value) < SAME } }

    private companion object {
        val OF_VECTORS = setOf(Part.DIRECTION, Part.POSITION, Part.COLOR, Part.ATTENUATION)
        val TINT = arrayOf("tint", "emi", "glow", "leucht", "object", "mesh", "material", "farbe", "base")
        val TABLE_1 = listOf(Vector3d(1.0, 0.5, 0.1), Vector3d(0.5, 0.05, 0.01))
        const val SAME = 1e-6
        const val NEARLY_PI = 3.14f
        const val HALF_CIRCLE = 180f
    }
}
