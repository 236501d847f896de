package cga.grading.sheet4.scene

import cga.exercise.components.shader.UniformNames
import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.findings.Check
import cga.grading.findings.Found
import cga.grading.findings.Mistake
import cga.grading.scene.ArrayNames
import cga.grading.scene.LightTrack
import cga.grading.scene.ProgramFacts

/**
 * Numbers that never arrive: sent to a name that no program has, or while no program was in use. They explain what is lacking, and nothing
 * else: a driver also drops uniforms that a shader does not need.
 *
 * @param uniforms the programs' active uniforms, to tell what a misspelt name was meant to be.
 * @param lights all lights that shine.
 */
internal class Lost(
    private val events: List<CapturedEvent>,
    private val uniforms: Set<String>,
    private val program: ProgramFacts,
    private val lights: List<LightTrack>,
) {
    private val asked = texts(EventKind.UNIFORM_ABSENT)
    private val names = asked.filterNot(program.declares)
    private val early = texts(EventKind.UNIFORM_WITHOUT_PROGRAM)
    private val unset = program.unset.orEmpty()

    /** What waits for numbers: all that is not known to have some, where nobody looked. */
    private val waiting = (program.unset ?: uniforms) + program.idle

    /** Names that are 0 for ever, or dropped by the compiler. */
    val unlit: Set<String> = unset + asked.filter(program.declares)

    /** [axes] with one cause for all that is lacking, where there is one, and what the events say besides. */
    fun explained(axes: List<Axis>): List<Axis> {
        val all = axes + lacking(axes)
        val lacks = all.mapNotNull { it.lack }
        val cause = cause(lacks, all.mapNotNull { it.mistake })
        val notes = texts(EventKind.GL_ERROR).map { Axis.note(say("event.gl-error", it)) }
        if (cause == null) return all + unneeded(all.any { it.lack != null }) + notes
        val hidden = all.mapNotNull { it.lack }.flatMap { it.hides }.toSet()
        return all.map { if (it.lack != null || it.mistake?.mistake in hidden) it.unnamed() else it } + cause + notes
    }

    private fun cause(lacks: List<Lack>, mistakes: List<Found>): Axis? {
        if (lacks.isEmpty()) return null
        val checks = lacks.flatMap { it.checks }.toSet()
        val isEarly = mistakes.any { it.mistake == Mistake.UNIFORM_BEFORE_USE }
        val kinds = lacks.map { it.kind }.toSet()
        if (!isEarly && early.isNotEmpty() && areLost(kinds)) {
            val calls = early.take(MOST_NAMES).joinToString()
            return Axis.wrong(Check.ORDER, 1.0, say("event.early", calls), Mistake.UNIFORM_BEFORE_USE, calls, explains = checks)
        }
        val meant = if (kinds == setOf(LackKind.OWN_COLOR)) asked.filter(::isColor) else names.filter(::matters)
        // The name of a colour: that costs where the emission is lacking.
        val isOfEmission = kinds.singleOrNull() == LackKind.COLOR
        if (isEarly || isOfEmission || meant.isEmpty() || (kinds != setOf(LackKind.OWN_COLOR) && !isMissed(meant))) return null
        val where = meant.sortedBy(::distance).take(MOST_NAMES).joinToString(transform = ::suggestion)
        val missing = say("event.missing", lacks.map { it.text }.distinct())
        return Axis.named(Axis.found(Mistake.UNIFORM_ABSENT, where, explains = checks), missing)
    }

    /** What of the programs waits for numbers although the scene looks whole without. */
    private fun lacking(axes: List<Axis>): List<Axis> =
        listOfNotNull(dead(axes), unplaced(), misspelt(CONE), misspelt(SHINE), besideArray())

    /** Where one light is divided by 0, nothing is left of the others; a light that is missing says so already. */
    private fun dead(axes: List<Axis>): Axis? {
        if (program.deadly.isEmpty()) return null
        val names = program.deadly.sorted().take(MOST_NAMES).joinToString()
        val text = say("event.deadly", names)
        if (axes.any { it.lack != null }) return Axis.note(text)
        return Axis.right(Check.POINT_LIGHT, 1.0, text).lacking(say("lack.numbers", names), Check.MORE_LIGHTS, Check.MORE_LIGHTS_SHADING)
    }

    /**
     * Lights whose place never arrives stand where the world begins. That may be meant, unless a name much like it is sent to nobody, or it
     * is sent while its program is not in use.
     */
    private fun unplaced(): Axis? {
        val lost = asked + early.map { it.substringAfter(' ') }
        val places = lights
            .mapNotNull { it.last.placedBy }
            .filter { place ->
                place in unset && lost.any { editDistance(it, place) <= place.length / MUCH_ALIKE }
            }.ifEmpty { return null }
        val text = places.joinToString()
        return Axis.note(say("event.unplaced", text)).lacking(say("lack.numbers", text), *PLACES, hides = UNPLACED)
    }

    /** Numbers of a cone, or an exponent, that are sent under a name which is much alike: what is left says nothing of what was meant. */
    private fun misspelt(words: Words): Axis? {
        val lost = unset
            .filter { words.regex.containsMatchIn(it) }
            .filter { name ->
                names.any { editDistance(it, name) <= TYPO || (words.regex.containsMatchIn(it) && isMostly(it, name)) }
            }.ifEmpty { return null }
        val text = lost.joinToString()
        val axis = Axis.right(words.checks[0], 1.0, say("event.other-name", text))
        return axis.lacking(say("lack.numbers", text), *words.checks, hides = words.hides)
    }

    /** Numbers that are sent to an element which an array does not have, while one that it has waits: a light is lost of however many. */
    private fun besideArray(): Axis? {
        val arrays = asked.mapNotNull(ArrayNames::arrayOf)
        val lost = unset.filter { ArrayNames.arrayOf(it) in arrays && LIGHT.containsMatchIn(it) }.ifEmpty { return null }
        val text = lost.joinToString()
        val axis = Axis.right(Check.MORE_LIGHTS, 1.0, say("event.other-element", text))
        return axis.lacking(say("lack.numbers", text), Check.MORE_LIGHTS_SHADING)
    }

    private fun unneeded(isLacking: Boolean): List<Axis> {
        val some = asked.take(MOST_NAMES).joinToString(transform = ::suggestion)
        return listOfNotNull(
            if (asked.isEmpty()) null else say(if (isLacking) "event.no-program" else "event.unneeded", some),
            if (early.isEmpty()) null else say("event.early-unneeded", early.take(MOST_NAMES).joinToString()),
        ).map(Axis::note)
    }

    /** Whether something that waits for numbers may have been meant by [names]: it is spelt alike, or nothing else is left for it. */
    private fun isMissed(names: List<String>): Boolean {
        if (program.unset == null) return true
        val alike = names.any { name -> waiting.any { it.commonPrefixWith(name).length + it.commonSuffixWith(name).length >= ALIKE } }
        return alike || (unset.isNotEmpty() && names.size >= unset.size)
    }

    /** Whether what was set too early is 0 for ever, or a colour is, which may arrive at another program under the same name. */
    private fun areLost(kinds: Set<LackKind>): Boolean {
        if (LackKind.COLOR in kinds || LackKind.OWN_COLOR in kinds) return early.any(COLOR_CALL::containsMatchIn)
        if (program.unset == null) return true
        return early.any { call -> ' ' !in call || waiting.any { it.removeSuffix("[0]") == call.substringAfter(' ').removeSuffix("[0]") } }
    }

    /** Whether [name] is that of a colour, and much like one that a shader has. */
    private fun isColor(name: String) = COLOR.containsMatchIn(name) && !program.declares(name) && distance(name) <= name.length / 2

    /** Whether a light could depend on it. */
    private fun matters(name: String) = LIGHT.containsMatchIn(name) || SHINE.regex.containsMatchIn(name) || distance(name) <= TYPO

    /** Whether two names begin and end alike in more than half of their letters: `lamp.cutOff`, `lamp.innerCutOff`. */
    private fun isMostly(
        a: String,
        b: String,
    ) = 2 * (a.commonPrefixWith(b).length + a.commonSuffixWith(b, true).length) > maxOf(a.length, b.length)

    private fun suggestion(name: String): String {
        val meant = nearest(name)
        return if (meant == null || distance(name) > name.length / 2) name else "$name (is $meant meant?)"
    }

    /** One that waits for numbers, if there is one that is much alike. */
    private fun nearest(name: String): String? {
        val alike = unset.filter { it in uniforms && editDistance(it, name) <= name.length / 2 }
        return alike.ifEmpty { uniforms }.minByOrNull { editDistance(it, name) }
    }

    private fun distance(name: String): Int = nearest(name)?.let { editDistance(it, name) } ?: Int.MAX_VALUE

    private fun texts(kind: EventKind) = events.filter { it.kind == kind }.map { it.text.take(LONGEST_NAME) }.distinct().take(MOST_TEXTS)

    /** What numbers of one kind are called, the checks that are wrong without them, and what it looks like. */
    private class Words(val regex: Regex, val hides: Set<Mistake>, vararg val checks: Check)

    private companion object {
        const val MOST_TEXTS = 64
        const val MOST_NAMES = 5
        const val LONGEST_NAME = 200
        const val TYPO = 2

        /** Of so many letters of two names for one thing at most one differs: `lights[0].pos`, `lights[0].position`. */
        const val MUCH_ALIKE = 3

        /** Letters at both ends that two names for one thing share at least: `Pos`, `bikeCol`. */
        const val ALIKE = 3

        fun words(text: String) = Regex(text, RegexOption.IGNORE_CASE)

        val CONE =
            Words(
                words("inner|outer|innen|au(ss|ß)en|cone|angle|winkel|kegel|cut|cos|phi|gamma|theta"),
                Mistake.entries.filter { it.check == Check.CONE || it.check == Check.SPOT_DIRECTION }.toSet(),
                Check.CONE, Check.SPOT_DIRECTION, Check.SPOT_LIGHT, Check.CONE_SPECULAR,
            )
        val SHINE = Words(words("shin|expo|gloss|glanz|phong"), setOf(Mistake.EXPONENT_FIXED), Check.SPECULAR)
        val COLOR = words("colou?r|farbe|emi|tint|glow")
        val COLOR_CALL = words("^glUniform3f.*(${COLOR.pattern})")
        val LIGHT = words("light|licht|lamp|point|punkt|spot|colou?r|farbe|pos|dir|att|cone|angle|winkel|corner")
        val PLACES = arrayOf(Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.SPOT_LIGHT_CHILD, Check.MORE_LIGHTS)
        val UNPLACED =
            setOf(Mistake.LIGHT_NOT_CHILD, Mistake.SPOT_NOT_CHILD, Mistake.LIGHT_IN_GROUND, Mistake.MORE_LIGHTS_ALIKE)
    }
}

/** How many letters must be put in, taken out or changed to make [a] into [b]; capital letters count as small ones. */
internal fun editDistance(a: String, b: String): Int = UniformNames.distance(a.lowercase(), b.lowercase())
