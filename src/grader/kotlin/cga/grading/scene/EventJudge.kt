package cga.grading.scene

import cga.exercise.components.shader.UniformNames
import cga.grading.capture.CapturedEvent
import cga.grading.capture.EventKind
import cga.grading.findings.Check
import cga.grading.findings.Mistake

/**
 * Do the calls beside the drawing explain what is missing? What is not missed is no mistake: a driver also drops uniforms that a shader
 * does not need.
 *
 * @param uniforms the programs' active uniforms, to tell what a misspelt name was meant to be.
 * @param lights all lights that shine.
 */
internal class EventJudge(
    private val events: List<CapturedEvent>,
    private val uniforms: Set<String>,
    private val program: ProgramFacts,
    private val lights: List<LightTrack>,
    private val book: Notebook,
) {
    /** To be called when everything else has been judged. */
    fun judge() {
        book.unlit += program.unset.orEmpty()
        refused()
        dialect()
        dead()
        unplaced()
        misspelt()
        misspeltExponent()
        besideArray()
        beforeUse()
        absent()
        for (text in texts(EventKind.GL_ERROR)) book.note("OpenGL reported $text.")
    }

    /** Shaders that the driver refused: what stands in for them shows nothing of the submission's shading, and of the rest what was understood. */
    private fun refused() {
        val log = events.firstOrNull { it.kind == EventKind.SHADER_FAILED || it.kind == EventKind.LINK_FAILED }?.text ?: return
        if (program.isReplaced) {
            book.isReplaced = true
            val hidden = SceneJudge.CHECKS.filter(::isHidden) - OrbitChecks.ALL
            book.unmeasured(hidden, SceneJudge.CHECKS - hidden.toSet(), "A shader was refused, so nothing of this can be seen.")
        }
        book.found(Mistake.SHADER_REFUSED, 0.0, 1.0, telling(log))
    }

    /** Whether [check] asks for more than the numbers tell that were sent to a shader that was refused. */
    private fun isHidden(check: Check) =
        check == Check.CONE || !program.isRead || (!program.isReadWhole && (book.error(check) ?: 0.0) > SOUND)

    /** Shaders that only needed other words: all that they do can be seen. */
    private fun dialect() {
        val log = texts(EventKind.SHADER_DIALECT).firstOrNull() ?: return
        book.spoilt(Check.ORDER, 1.0, "A shader compiles with some drivers only; it was graded all the same.")
        book.found(Mistake.GLSL_DRIVER, 0.0, 1.0, telling(log))
    }

    /** The stage and the first error. */
    private fun telling(log: String): String {
        val lines = log.lines().filter { it.isNotBlank() }
        val telling = listOfNotNull(lines.firstOrNull(), lines.find { ERROR.containsMatchIn(it) } ?: lines.getOrNull(1))
        return telling.distinct().joinToString(": ") { it.trim() }
    }

    /** Where one light is divided by 0, nothing is left of the others; a light that is missing says so already. */
    private fun dead() {
        if (program.deadly.isEmpty() || book.isReplaced) return
        val names = program.deadly.sorted().take(MOST_NAMES).joinToString()
        val text = "Nothing of the picture is a number, because $names is 0 in every frame."
        if (book.missing.isNotEmpty()) return book.note(text)
        book.spoilt(Check.POINT_LIGHT, 1.0, text)
        book.lacks("the numbers of $names", setOf(Check.POINT_LIGHT, Check.MORE_LIGHTS, Check.MORE_LIGHTS_SHADING), emptySet())
    }

    /**
     * Lights whose place never arrives stand where the world begins. That may be meant, unless a name much like it is sent to nobody, or it
     * is sent while its program is not in use.
     */
    private fun unplaced() {
        val lost = texts(EventKind.UNIFORM_ABSENT) + texts(EventKind.UNIFORM_WITHOUT_PROGRAM).map { it.substringAfter(' ') }
        val waiting = lights.mapNotNull { it.last.placedBy }.filter { it in program.unset.orEmpty() }
        val places = waiting.filter { place -> lost.any { editDistance(it, place) <= place.length / MUCH_ALIKE } }.ifEmpty { return }
        book.lacks(
            places.joinToString(),
            setOf(Check.POINT_LIGHT_CHILD, Check.POINT_LIGHT_POSITION, Check.SPOT_LIGHT_CHILD, Check.MORE_LIGHTS),
            setOf(Mistake.LIGHT_NOT_CHILD, Mistake.SPOT_NOT_CHILD, Mistake.LIGHT_IN_GROUND, Mistake.MORE_LIGHTS_ALIKE),
        )
    }

    /** Numbers of a cone that are sent under a name which is much alike: the cone that is left says nothing of what was meant. */
    private fun misspelt() {
        val waiting = program.unset.orEmpty().filter { CONE_WORDS.containsMatchIn(it) }
        val asked = texts(EventKind.UNIFORM_ABSENT).filterNot(::isDeclared)
        val lost = waiting
            .filter { name ->
                asked.any {
                    editDistance(it, name) <= TYPO ||
                        (CONE_WORDS.containsMatchIn(it) && isMostly(it, name))
                }
            }.ifEmpty { return }
        book.spoilt(Check.CONE, 1.0, "${lost.joinToString()} never arrives: it is sent under another name.")
        book.lacks(lost.joinToString(), setOf(Check.CONE, Check.SPOT_DIRECTION, Check.SPOT_LIGHT, Check.CONE_SPECULAR), CONES)
    }

    /** An exponent that is sent under a name which is much alike: the study sees that it follows nothing that is sent. */
    private fun misspeltExponent() {
        val waiting = program.unset.orEmpty().filter { SHINE_WORDS.containsMatchIn(it) }
        val asked = texts(EventKind.UNIFORM_ABSENT).filter { SHINE_WORDS.containsMatchIn(it) && !isDeclared(it) }
        val lost = waiting.filter { name -> asked.any { editDistance(it, name) <= TYPO || isMostly(it, name) } }.ifEmpty { return }
        book.spoilt(Check.SPECULAR, 1.0, "${lost.joinToString()} never arrives: it is sent under another name.")
        book.lacks(lost.joinToString(), setOf(Check.SPECULAR), setOf(Mistake.EXPONENT_FIXED))
    }

    /** Whether two names begin and end alike in more than half of their letters: `lamp.cutOff`, `lamp.innerCutOff`. */
    private fun isMostly(a: String, b: String) =
        2 * (a.commonPrefixWith(b).length + a.commonSuffixWith(b, true).length) > maxOf(a.length, b.length)

    /** Numbers that are sent to an element which an array does not have, while one that it has waits: a light is lost of however many. */
    private fun besideArray() {
        val asked = texts(EventKind.UNIFORM_ABSENT).mapNotNull(ArrayNames::arrayOf)
        val lost = program.unset.orEmpty().filter { ArrayNames.arrayOf(it) in asked && LIGHT_WORDS.containsMatchIn(it) }.ifEmpty { return }
        book.spoilt(Check.MORE_LIGHTS, 1.0, "${lost.joinToString()} never arrives: it is sent to another element.")
        book.lacks(lost.joinToString(), setOf(Check.MORE_LIGHTS, Check.MORE_LIGHTS_SHADING), setOf(Mistake.MORE_LIGHTS_MISSING))
    }

    private fun absent() {
        val asked = texts(EventKind.UNIFORM_ABSENT).distinct()
        val names = asked.filter { matters(it) && !isDeclared(it) }
        book.unlit += asked.filter(::isDeclared)
        when {
            asked.isEmpty() || book.isReplaced -> return
            book.missing == listOf(ColorJudge.OWN_COLOR) && asked.any(::isColor) && !book.has(Mistake.UNIFORM_BEFORE_USE) ->
                book.explained(Mistake.UNIFORM_ABSENT, asked.filter(::isColor).take(MOST_NAMES).joinToString(transform = ::suggestion))
            // The name of a colour: that costs where the emission is lacking.
            book.missing.singleOrNull() in COLORS ->
                book.note("Set but in no program: ${asked.take(MOST_NAMES).joinToString(transform = ::suggestion)}.")
            book.missing.isEmpty() || names.isEmpty() || !isMissed(names) || book.has(Mistake.UNIFORM_BEFORE_USE) ->
                book.note("Set but in no program: ${asked.take(MOST_NAMES).joinToString()}. The picture lacks nothing of them.")
            else -> {
                val likeliest = names.sortedBy { distance(it) }.take(MOST_NAMES)
                book.explained(Mistake.UNIFORM_ABSENT, likeliest.joinToString(transform = ::suggestion))
            }
        }
    }

    /** Whether [name] is that of a colour, and much like one that a shader has. */
    private fun isColor(name: String) = COLOR_WORDS.containsMatchIn(name) && !isDeclared(name) && distance(name) <= name.length / 2

    /** Whether the compiler may have dropped the uniform because nothing depends on it: then its name is spelt right. */
    private fun isDeclared(name: String) = program.declares(name)

    /** Whether something that waits for numbers may have been meant by [names]: it is spelt alike, or nothing else is left for it. */
    private fun isMissed(names: List<String>): Boolean {
        val unset = program.unset ?: return true
        val waiting = unset + program.idle
        val alike = names.any { name -> waiting.any { (name.commonPrefixWith(it).length + name.commonSuffixWith(it).length) >= ALIKE } }
        return alike || (unset.isNotEmpty() && names.size >= unset.size)
    }

    private fun beforeUse() {
        val calls = texts(EventKind.UNIFORM_WITHOUT_PROGRAM)
        if (calls.isEmpty() || book.isReplaced || book.has(Mistake.UNIFORM_BEFORE_USE)) return
        if (book.missing.isEmpty() || !areLost(calls)) {
            val few = calls.take(MOST_NAMES).joinToString()
            book.note("Uniforms were set while their program was not in use ($few); the picture lacks nothing of them.")
        } else {
            book.measured(Check.ORDER, 1.0, "Set while no program was in use: ${calls.take(MOST_NAMES).joinToString()}.")
            book.explained(Mistake.UNIFORM_BEFORE_USE, calls.take(MOST_NAMES).joinToString())
        }
    }

    /** Whether what [calls] set is 0 for ever. */
    private fun areLost(calls: List<String>): Boolean {
        // A colour that one program never gets may arrive at another under the same name.
        if (book.missing.any { it in COLORS } && calls.any(COLOR_CALL::containsMatchIn)) return true
        if (book.missing == listOf(ColorJudge.OWN_COLOR)) return false
        val waiting = (program.unset ?: return true) + program.idle
        return calls.any { call -> ' ' !in call || waiting.any { it.removeSuffix("[0]") == call.substringAfter(' ').removeSuffix("[0]") } }
    }

    private fun texts(kind: EventKind) = events.filter { it.kind == kind }.map { it.text.take(LONGEST_NAME) }.distinct().take(MOST_TEXTS)

    /** Whether a light could depend on it. */
    private fun matters(name: String) = LIGHT_WORDS.containsMatchIn(name) || SHINE_WORDS.containsMatchIn(name) || distance(name) <= TYPO

    private fun suggestion(name: String): String {
        val meant = nearest(name)
        return if (meant == null || distance(name) > name.length / 2) name else "$name (is $meant meant?)"
    }

    /** One that waits for numbers, if there is one that is much alike. */
    private fun nearest(name: String): String? {
        val waiting = program.unset.orEmpty().filter { it in uniforms && editDistance(it, name) <= name.length / 2 }
        return waiting.ifEmpty { uniforms }.minByOrNull { editDistance(it, name) }
    }

    private fun distance(name: String): Int = nearest(name)?.let { editDistance(it, name) } ?: Int.MAX_VALUE

    private companion object {
        const val MOST_TEXTS = 64
        val CONE_WORDS = Regex("inner|outer|innen|au(ss|ß)en|cone|angle|winkel|kegel|cut|cos|phi|gamma|theta", RegexOption.IGNORE_CASE)

        val SHINE_WORDS = Regex("shin|expo|gloss|glanz|phong", RegexOption.IGNORE_CASE)

        /** What half a cone may look like. */
        val CONES = Mistake.entries.filter { it.check == Check.CONE || it.check == Check.SPOT_DIRECTION }.toSet()

        /** Of so many letters of two names for one thing at most one differs: `lights[0].pos`, `lights[0].position`. */
        const val MUCH_ALIKE = 3

        /** An error that every tolerance of the rubric allows. */
        const val SOUND = 0.01
        val ERROR = Regex("\\berror\\b", RegexOption.IGNORE_CASE)

        /** Letters at both ends that two names for one thing share at least: `Pos`, `bikeCol`. */
        const val ALIKE = 3
        const val MOST_NAMES = 5
        const val LONGEST_NAME = 200
        const val TYPO = 2
        val COLORS = setOf(ColorJudge.COLOR, ColorJudge.OWN_COLOR)
        val COLOR_WORDS = Regex("colou?r|farbe|emi|tint|glow", RegexOption.IGNORE_CASE)
        val COLOR_CALL = Regex("^glUniform3f.*(${COLOR_WORDS.pattern})", RegexOption.IGNORE_CASE)
        val LIGHT_WORDS =
            Regex("light|licht|lamp|point|punkt|spot|colou?r|farbe|pos|dir|att|cone|angle|winkel|corner", RegexOption.IGNORE_CASE)
    }
}

/** How many letters must be put in, taken out or changed to make [a] into [b]; capital letters count as small ones. */
internal fun editDistance(
    a: String,
    b: String,
): Int = UniformNames.distance(a.lowercase(), b.lowercase())
