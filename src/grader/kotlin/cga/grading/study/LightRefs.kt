package cga.grading.study

import cga.grading.scene.ArrayNames
import cga.grading.scene.ObservedCone
import cga.grading.scene.ObservedLight
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc
import kotlin.math.abs
import kotlin.math.acos

/** Where one number of a light comes from: a component of a uniform, or always the same. */
internal class NumberRef(
    val name: String?,
    private val index: Int,
    private val constant: Double,
) {
    /** The same number of [element] of an array. */
    fun of(element: String) = NumberRef(name?.replaceFirst(ArrayNames.ELEMENT, element), index, constant)

    /** The number that [values] give. */
    fun of(values: Map<String, FloatArray>): Double = name?.let { values[it]?.getOrNull(index)?.toDouble() } ?: constant
}

/**
 * Where a position or direction comes from.
 *
 * @param space the one that the uniform is in, null for a constant of the world.
 * @param first which of the uniform's numbers is x: a matrix has several vectors.
 */
internal class VectorRef(
    val name: String?,
    private val space: Space?,
    private val factor: Double,
    private val constant: Vector3dc,
    private val first: Int = 0,
) {
    /** The same of [element] of an array. */
    fun of(element: String) = VectorRef(name?.replaceFirst(ArrayNames.ELEMENT, element), space, factor, constant, first)

    /** Whether it is a uniform in world space. */
    val isViewed: Boolean get() = name != null && space == Space.WORLD

    fun position(
        values: Map<String, FloatArray>,
        view: Matrix4dc,
    ): Vector3d = raw(values).let { if (space == Space.VIEW) it else view.transformPosition(it) }

    fun direction(
        values: Map<String, FloatArray>,
        view: Matrix4dc,
    ): Vector3d = raw(values).let { if (space == Space.VIEW) it else view.transformDirection(it) }.normalize().mul(factor)

    private fun raw(values: Map<String, FloatArray>): Vector3d {
        val value = name?.let { values[it] } ?: return Vector3d(constant)
        return vector(value, first)
    }

    companion object {
        /** Three of [numbers], from [first] on. */
        fun vector(
            numbers: FloatArray,
            first: Int,
        ): Vector3d = Vector3d(numbers[first].toDouble(), numbers[first + 1].toDouble(), numbers[first + 2].toDouble())
    }
}

/**
 * A light in terms of uniforms, so that it can be told for every draw without measuring again.
 *
 * @param scale what the colour is multiplied with: an intensity.
 * @param meter of a colour that no uniform holds, [axisMeter] of a direction that none does, [placeMeter] of such a place.
 */
internal class LightRefs(
    private val name: String,
    val color: String,
    private val scale: Double,
    private val position: VectorRef,
    private val k: List<NumberRef>,
    private val cone: ConeRefs?,
    private val meter: ColorMeter? = null,
    private val axisMeter: AxisMeter? = null,
    private val placeMeter: PlaceMeter? = null,
) {
    /** The direction of a cone and what makes its edges. */
    internal class ConeRefs(
        val direction: VectorRef,
        val form: AngleForm,
        val inner: NumberRef,
        val outer: NumberRef,
        val isReversed: Boolean,
    )

    private val fadedBy = k.mapNotNull { it.name }.toSet()

    /** The light as a draw with the uniforms [values] takes it. */
    fun light(
        values: Map<String, FloatArray>,
        view: Matrix4dc,
        spaces: Spaces,
    ): ObservedLight {
        val c = values[color] ?: FloatArray(3)
        val place = placeMeter?.place(values, spaces)?.let(::Vector3d) ?: position.position(values, view)
        val law = Vector3d(k[0].of(values), k[1].of(values), k[2].of(values))
        val axis = axisMeter?.axis(values, spaces, place) ?: cone?.direction?.direction(values, view)
        return ObservedLight(
            name = name,
            position = place,
            color =
                meter?.color(values, spaces, place, axis ?: Vector3d(0.0, -1.0, 0.0), law)
                    ?: Vector3d(c[0].toDouble(), c[1].toDouble(), c[2].toDouble()).mul(scale),
            k = law,
            spot =
                if (cone == null || axis == null) {
                    null
                } else {
                    ObservedCone(axis, angle(cone, cone.inner, values), angle(cone, cone.outer, values))
                },
            placedBy = position.name,
            isViewed = position.isViewed,
            fadedBy = fadedBy,
        )
    }

    /** The point light of [element] in the arrays that this one's numbers are in; null where its place is in none of the [active] uniforms. */
    fun sentTo(element: String, active: Set<String>): LightRefs? {
        val slot = color.replaceFirst(ArrayNames.ELEMENT, element)
        val place = position.of(element)
        // Lights that are packed into one array, one number after the other, have elements that are no lights.
        val isPacked = position.name?.let(ArrayNames.ELEMENT::find)?.value != ArrayNames.ELEMENT.find(color)?.value
        if (cone != null || isPacked || place.name == position.name || place.name !in active) return null
        return LightRefs(slot, slot, scale, place, k.map { it.of(element) }, null)
    }

    private fun angle(
        cone: ConeRefs,
        number: NumberRef,
        values: Map<String, FloatArray>,
    ): Double {
        val cosine = cone.form.cosine(number.of(values)) * if (cone.isReversed) -1 else 1
        return if (abs(cosine) <= 1) acos(cosine) else Double.NaN
    }

    companion object {
        /** Finds the uniforms behind [light]; several lights where several share its colour, none where it could not be placed. */
        fun of(
            light: LightModel,
            study: ProgramStudy,
        ): List<LightRefs> {
            val finder = RefFinder(light, study)
            if (light.shared.isNotEmpty()) {
                return light.shared.mapIndexed { i, shared ->
                    val (k, scale) = finder.attenuation(shared.attenuation?.k ?: Vector3d(1.0, 0.0, 0.0))
                    LightRefs("${light.name} (${i + 1})", light.probe.slot.name, scale, finder.position(Vector3d(shared.view)), k, null)
                }
            }
            val placement = light.placement ?: return listOfNotNull(light.guess?.let { guessed(light, finder, it) })
            val law = light.attenuation?.k ?: Vector3d(1.0, 0.0, 0.0)
            // Vectors that were normalised too early are 1 long everywhere: what is seen is F(1), and that is a defect of its own.
            val (k, scale) = (if (LightDeviations.isAtLengthOne(light)) finder.sumOf(law.x())?.let { finder.attenuation(it) } else null)
                ?: finder.attenuation(law)
            val cone = light.cone?.let { finder.cone(it, placement.directionToView(it.axis)) }
            val slot = light.probe.slot
            val roles = study.roles
            val meter = if (roles == null || slot !in study.box.program.deep) null else ColorMeter(study, slot, roles.onlyDiffuse)
            // Where the distances are measured from the light is, whatever the directions say, unless another light or the camera is there:
            // one of both is a defect of its own.
            val isCopied = light.fadesFromEye || study.distanceOf(light) != null
            val place = Vector3d(light.attenuation?.from?.takeUnless { isCopied } ?: placement.view)
            val axisMeter = if (cone?.direction?.name == null) AxisMeter.of(light, study) else null
            val position = finder.position(place)
            val placeMeter = if (position.name == null) PlaceMeter.of(light, study) else null
            return listOf(LightRefs(light.name, slot.name, scale, position, k, cone, meter, axisMeter, placeMeter))
        }

        /** All that can be said of a light that is somewhere: nothing of its K. */
        private fun guessed(
            light: LightModel,
            finder: RefFinder,
            place: Vector3dc,
        ) = LightRefs(
            light.name, light.probe.slot.name, 1.0,
            finder.position(
                Vector3d(place),
            ),
            List(3) { NumberRef(null, 0, Double.NaN) }, null,
        )
    }
}
