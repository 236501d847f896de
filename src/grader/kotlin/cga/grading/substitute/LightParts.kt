package cga.grading.substitute

import cga.grading.sheet4.scene.SceneProfile
import org.joml.Vector3d
import org.lwjgl.opengl.GL33C.GL_FLOAT
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC2
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC3
import org.lwjgl.opengl.GL33C.GL_FLOAT_VEC4

/**
 * The uniforms of one light.
 *
 * @param attenuation GLSL for (K_c, K_l, K_q); null where they are not sent.
 * @param direction null for a point light; [cone] likewise.
 */
internal class LightParts(
    val position: String,
    val color: String,
    val attenuation: String?,
    val direction: String?,
    val cone: ConeParts?,
)

/**
 * Which uniforms belong together, told by what is left of their names without the words for the part.
 *
 * @property tint name of the emission's factor: a colour that differs between the draws of a picture, or is called so.
 * @property rest vectors that nothing is known of.
 */
internal class LightGroups(
    private val sent: Sent,
) {
    private val vectors = (sent.names(GL_FLOAT_VEC3) + sent.names(GL_FLOAT_VEC4)).map(::UniformName)
    private val numbers = (sent.names(GL_FLOAT) + sent.names(GL_FLOAT_VEC2)).map(::UniformName)
    val tint: String? = (vectors.find { isPaint(it) && differs(it.name) } ?: vectors.find { isPaint(it) && it.says(TINT) })?.name
    private val known = vectors.filter { it.name != tint && !it.says(AMBIENT) && !isEye(it) }
    private val colors = known.filter { part(it) == Part.COLOR }
    private val directions = known.filter { part(it) == Part.DIRECTION && isEver(it.name) }
    private val fades = known.filter { part(it) == Part.ATTENUATION }
    private val pairs = pairs(known.filter { part(it) == Part.POSITION })
    private val headlight = headlight()

    /** In the order of their places' uniforms. */
    val lights: List<LightParts> = pairs.filterValues(::isSent).map { (owner, pair) -> light(owner, pair.first.name, pair.second.name) }
    val rest: List<String> =
        (known - (pairs.values.flatMap { it.toList() } + fades).toSet()).filter { part(it) != Part.DIRECTION }.map { it.name }

    /** Place and colour of each light, by its words. Where one of each is left over with different words, they are one light's. */
    private fun pairs(places: List<UniformName>): Map<String, Pair<UniformName, UniformName>> {
        val named = places.mapNotNull { place -> colors.find { it.owner == place.owner }?.let { place.owner to (place to it) } }.toMap()
        val lonely = places.filter { it.owner !in named }
        val spare = colors.filter { it.owner !in named }
        if (lonely.size != spare.size) return named
        return named + lonely.zip(spare).associate { (place, color) -> place.owner to (place to color) }
    }

    /** The one to whom belongs what has lost its owner: the only spotlight, or what is called one. */
    private fun headlight(): String? =
        pairs.keys.singleOrNull { owner -> (directions + numbers.filter { it.isCone }).any { it.owner == owner } }
            ?: pairs.keys.singleOrNull { UniformName(it).says(HEADLIGHT) }

    /** Whether one of [pair] is ever anything: arrays may be longer than there are lights. */
    private fun isSent(pair: Pair<UniformName, UniformName>) = pair.toList().any { isEver(it.name) }

    private fun isEver(name: String) = sent.vectors(name).any { it.lengthSquared() > 0 }

    private fun light(
        owner: String,
        place: String,
        color: String,
    ): LightParts {
        val direction = directions.find { it.owner == owner } ?: directions.singleOrNull()?.takeIf { owner == headlight }
        val own = numbers.filter { it.isCone && (it.owner == owner || (owner == headlight && it.owner !in pairs)) }
        val cone = if (direction == null) null else ConeParts.of(own.map { it to sent.last.numbers(it.name) })
        return LightParts(place, color, fade(owner), direction?.name.takeIf { cone != null }, cone)
    }

    private fun fade(owner: String): String? {
        fades.find { it.owner == owner }?.let { return "${it.name}.xyz" }
        val factors = FACTORS.map { part -> numbers.find { it.owner == owner && part in it.parts }?.name }
        if (factors.any { it != null }) return "vec3(${factors.joinToString { it ?: "0.0" }})"
        return fades.singleOrNull { it.owner !in pairs }?.let { "${it.name}.xyz" }
    }

    private fun isEye(name: UniformName) = name.says(EYE) || (part(name) == Part.POSITION && name.owner == "view")

    private fun isPaint(name: UniformName) =
        part(name).let { it == Part.COLOR || it == null } && sent.types[name.name] == GL_FLOAT_VEC3 && !name.says(AMBIENT)

    private fun differs(name: String) = sent.frames.any { frame -> frame.any { it.vector(name) != frame[0].vector(name) } }

    private fun part(name: UniformName): Part? =
        name.parts.firstOrNull { it in OF_VECTORS } ?: Part.ATTENUATION.takeIf { isTable1(sent.last.vector(name.name)) }

    private fun isTable1(k: Vector3d) = TABLE_1.any { it.distance(k) < SAME }

    private companion object {
        val OF_VECTORS = setOf(Part.DIRECTION, Part.POSITION, Part.COLOR, Part.ATTENUATION)
        val FACTORS = listOf(Part.CONSTANT, Part.LINEAR, Part.QUADRATIC)
        val TINT = listOf("tint", "emi", "glow", "leucht", "object", "mesh", "material", "farbe", "base")
        val EYE = listOf("cam", "eye", "auge", "kamera")
        val AMBIENT = listOf("amb")
        val HEADLIGHT = listOf("spot", "head", "scheinw", "strahler", "front", "beam")
        val TABLE_1 = with(SceneProfile.SHEET) { listOfNotNull(pointK, spotK) }
        const val SAME = 1e-6
    }
}
