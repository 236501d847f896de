package cga.grading.study

import cga.grading.findings.Check
import cga.grading.findings.Mistake

/** What is wrong with the textures of a program: which term each colours, and whether it is there at all. */
internal object MaterialDeviations {
    fun of(study: ProgramStudy): List<Deviation> {
        val roles = study.roles ?: return emptyList()
        val found = mutableListOf<Deviation>()

        fun add(
            mistake: Mistake,
            check: Check = mistake.check,
            why: String = "",
        ) {
            found += Deviation(mistake, "", 0.0, 1.0, check = check, why = why)
        }
        if (roles.isShared) add(Mistake.UNKNOWN, Check.MATERIAL)
        if (roles.diffuse == null && roles.specular != null) add(Mistake.DIFFUSE_MISSING)
        if (roles.specular == null && roles.untextured < 1e-3) add(Mistake.SPECULAR_MISSING)
        val shared = sharedUnits(study)
        when {
            shared.any { it != 0f } -> add(Mistake.UNKNOWN, Check.MATERIAL, "two samplers read one texture unit")
            // What it reads in the place of its own map is another's.
            isAtWrongUnit(study, roles) -> add(Mistake.SAMPLER_UNIT)
            roles.peak != Peak.POWER && isSwapped(roles, study.samplers.files, study.samplers.there) -> add(Mistake.MAPS_SWAPPED)
        }
        if (study.exponent < 1 || roles.powers.values.any { it < ENCODED }) add(Mistake.GAMMA_DIRECTION)
        if (roles.powers.values.any { it > DECODED_TWICE }) add(Mistake.UNKNOWN, Check.MATERIAL, "a texture is decoded twice")
        return found
    }

    /** Whether two samplers read one unit, or one reads a unit at which no draw finds a texture. */
    private fun isAtWrongUnit(
        study: ProgramStudy,
        roles: TextureRoles,
    ): Boolean {
        val used = listOf(roles.emission, roles.diffuse, roles.specular)
        return sharedUnits(study).isNotEmpty() || used.any { it in study.samplers.unbound }
    }

    /** The texture units that more than one sampler reads. */
    private fun sharedUnits(study: ProgramStudy): Set<Float> {
        val units = study.box.program.samplers.mapNotNull { study.box.values[it.name]?.firstOrNull() }
        return units.groupBy { it }.filterValues { it.size > 1 }.keys
    }

    /**
     * Whether the files that the samplers read, or where none is known their own names, say that they have another's work. One of two
     * samplers that read the same has, if a file for its own use is [there].
     */
    fun isSwapped(
        roles: TextureRoles,
        files: Map<String, Set<String>>,
        there: Set<String> = emptySet(),
    ): Boolean {
        val known = there.mapNotNull(MapWord::of).toSet()
        val samplers =
            mapOf(MapWord.EMISSION to roles.emission, MapWord.DIFFUSE to roles.diffuse, MapWord.SPECULAR to roles.specular)
                .mapNotNull { (use, sampler) -> sampler?.let { use to it } }
        val words = samplers.associate { (_, sampler) ->
            sampler to (if (files.isEmpty()) setOf(sampler) else files[sampler].orEmpty()).mapNotNull(MapWord::of).toSet()
        }
        return samplers.any { (use, sampler) ->
            samplers.any { (other, its) ->
                val (said, itSaid) = words.getValue(sampler) to words.getValue(its)
                sampler != its && (haveMoved(use, said, other, itSaid) || (said == setOf(other) && said == itSaid && use in known))
            }
        }
    }

    /** Whether what belongs to the use [b] is at [a], and not only because there is nothing else: at [b] is something else instead. */
    private fun haveMoved(
        a: MapWord,
        saidByA: Set<MapWord>,
        b: MapWord,
        saidByB: Set<MapWord>,
    ) = b in saidByA && (a in saidByB || (saidByB.isNotEmpty() && b !in saidByB))

    // A texture is taken as it is (1) or decoded (2.2); what makes it brighter encodes it once more.
    private const val ENCODED = 0.8

    /** Halfway from one decoding to two. */
    private const val DECODED_TWICE = 3.3
}

/** What names of textures say about their use. */
private enum class MapWord(private val pattern: Regex) {
    EMISSION(Regex("emit|emis|glow|ems", RegexOption.IGNORE_CASE)),
    DIFFUSE(Regex("diff|albedo|base", RegexOption.IGNORE_CASE)),
    SPECULAR(Regex("spec|gloss|shin", RegexOption.IGNORE_CASE)),
    ;

    companion object {
        /** The one use that [name] speaks of, null where it speaks of none or of several. */
        fun of(name: String): MapWord? = entries.filter { it.pattern.containsMatchIn(name) }.singleOrNull()
    }
}
