package cga.grading.sheet4.scene

import cga.grading.scene.percent
import cga.grading.scene.text
import org.joml.Vector3dc
import java.util.Properties

/** The sentence [key] of `scene.properties` with [values] in its places: numbers rounded, vectors in brackets. */
internal fun say(key: String, vararg values: Any): String {
    val sentence = checkNotNull(SENTENCES.getProperty(key)) { "scene.properties has no $key" }
    return values.foldIndexed(sentence) { i, text, value -> text.replace("{$i}", said(value)) }
}

/** A share, to be said in percent. */
internal class Share(val value: Double)

private fun said(value: Any): String =
    when (value) {
        is Double -> value.text()
        is Vector3dc -> value.text()
        is Share -> value.value.percent()
        else -> value.toString()
    }

private val SENTENCES: Properties =
    Properties().apply {
        checkNotNull(Axis::class.java.getResourceAsStream("scene.properties")) { "scene.properties is missing" }.reader().use(::load)
    }
