package cga.measure.accuracy

/**
 * What is computed and compared, in the oracle's words; what each takes and means is written in tests/glm/oracle.cpp.
 *
 * @param label how the oracle calls it.
 * @param floor the smallest number that errors are related to. Factors are multiplied to colours of about 1, so an error is seen
 * in parts of 1 even where the factor itself is nearly 0.
 */
public enum class Operation(
    public val label: String,
    internal val floor: Double = 0.0,
) {
    ROTATION("rotation"),
    ENDLESS_ROTATION("endless rotation"),
    PLACING("placing"),
    MOVING("moving"),
    PARENTS("parents"),
    TURN_ABOUT_POINT("turn about a point"),
    LOOK_AT("look-at"),
    CAMERA("camera"),
    MODEL_VIEW("model-view"),
    PERSPECTIVE("perspective"),
    NORMAL_MATRIX("normal matrix"),
    CONE_OF_COSINES("cone of cosines", floor = 1.0),
    CONE_OF_VERSINES("cone of versines", floor = 1.0),
    ATTENUATION("attenuation", floor = 1.0),
    ;

    internal companion object {
        fun of(label: String): Operation = entries.first { it.label == label }
    }
}
